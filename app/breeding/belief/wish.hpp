// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::breeding {

// Coordinates of one aspect, each in [0, 1]: its words, or its parameters as shares of their ranges.
using Place = std::vector<double>;

// A Gaussian belief about where, in one aspect, the visitor's wish lies. Exact on every processor.
struct Wish {
    Place mean;
    std::vector<double> covariance;  // row by row; symmetric, positive definite
    double evidence = 0;             // log probability of the picks so far
    friend bool operator==(const Wish&, const Wish&) = default;
};

// Knows nothing: the middle, with the deviation of a uniform number.
Wish isotropic_wish(std::size_t dimensions);

// Near what people who know landscapes have made; at least one archetype.
Wish archetype_wish(std::span<const Place> archetypes);

// `picked` of the places shown was named best: the wish lies nearer to it than to each of the others. Each is a
// half-space, taken in by a rank-one probit update (assumed-density filtering: Minka 2001), with a share of picks that
// mean nothing, noise in the eye, and unknown weights of the coordinates.
Wish learnt(Wish wish, std::span<const Place> shown, std::size_t picked);

// A draw from it; coordinates may leave [0, 1].
Place drawn(const Wish& wish, const std::vector<double>& root, base::RandomStream& chance);
std::vector<double> root_of(const Wish& wish);  // the lower triangular root of its covariance (Cholesky), row by row

}  // namespace quadrat::breeding
