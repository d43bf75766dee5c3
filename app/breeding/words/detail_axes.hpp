// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {

// Directions in which scenes with the same words still differ visibly, and how much one sees of each parameter.
struct DetailAxes {
    std::map<genome::ParameterId, double> seen;               // at least 0; of its whole range, 1 on average
    std::vector<std::map<genome::ParameterId, double>> axes;  // what one sees most of first; parameters left out: 0
    friend bool operator==(const DetailAxes&, const DetailAxes&) = default;
};

// How a picture changes when each parameter of an aspect, in table order, goes all its range: a row a parameter.
using PictureJacobian = Eigen::MatrixXf;

// Principal components of what the map leaves over (its leave-one-out spread, beside the word axes), as pictures tell
// them: eigenvectors of C½ G C½ with G the mean of J J' over several landscapes (Chiu et al. 2020, "Human-in-the-loop
// differential subspace search", searched along singular vectors of such a Jacobian). `count` at most.
DetailAxes detail_axes(const WordMap& map, genome::Aspect aspect, std::span<const PictureJacobian> pictures,
                       std::size_t count);

// {"quadrat":"detail axes","version":1,"aspect":"trees","seen":{"tree.height_m":1.2,…},"axes":[{…},…]}
std::string to_json(const DetailAxes& axes, genome::Aspect aspect);

// Parameters that this program does not have are passed over: axes are measured seldom. Throws InputError otherwise.
DetailAxes detail_axes_from(std::string_view json, std::string_view source, genome::Aspect aspect);

// Those that come along; nothing seen and no axes where none were measured.
const DetailAxes& measured_axes(genome::Aspect aspect);

}  // namespace quadrat::breeding
