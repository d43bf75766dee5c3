// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "breeding/words/basis.hpp"
#include "genome/parameter_table.hpp"

namespace quadrat::breeding {

class WordMap;

// A wish as people have it who say "something of this and something of that": up to three named scenes and the share of
// each, in sum 1.
struct Blend {
    std::array<std::size_t, 3> of{};
    std::array<double, 3> shares{};
};

// What is known of an aspect before anybody comes: the named scenes that a wish may be near, and the axes along which
// scenes go apart from them. Parameters are shares of their ranges, in the order of `ids`. The same, bit for bit, for
// the same word map.
struct Atlas {
    static constexpr std::size_t kBlends = 768;

    std::vector<genome::ParameterId> ids;
    std::vector<std::string> names;   // of the named scenes
    std::vector<Point> named;         // parameters of the named scenes
    std::vector<Point> named_words;   // their words, from -1 to 1
    std::vector<Blend> blends;        // kBlends of them, the likelier ones more often; none where no scene is named
    std::vector<Point> blend_places;  // their parameters
    Point middle;                     // the mean of the named scenes
    Point middle_words;

    // Orthonormal axes in the space of parameters, together a basis of those that are amounts: first as words move
    // them, then the detail axes, then what is left.
    std::vector<Point> axes;
    std::size_t word_axes = 0;
    std::size_t detail_axes = 0;

    std::vector<Point> words_by_parameter;  // how far each word goes when a parameter goes all its range
    Point seen;                             // how much one sees of a parameter; 1 on average
};

Atlas atlas_of(const WordMap& map, genome::Aspect aspect);

// The words of a place, by how far it is from the middle.
Point words_at(const Atlas& atlas, const Point& parameters);

// Along the axes, and back.
Point along_axes(const Atlas& atlas, const Point& parameters);
Point from_axes(const Atlas& atlas, const Point& along);

}  // namespace quadrat::breeding
