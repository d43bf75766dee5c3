// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <span>

#include "breeding/belief/wish.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

using FourPlaces = std::array<Place, genome::kCandidates>;

// The four places that leave the least mean squared distance to the nearest of them (Lloyd 1982, begun by farthest
// points): what to show so that whatever the wish is, one of the four is near it. At least four samples.
FourPlaces four_means(std::span<const Place> samples);

// Indices of the places in an order in which each is farthest from those before it, begun by `first`.
std::vector<std::size_t> farthest_first(std::span<const Place> places, std::size_t first, std::size_t count);

double squared_distance(const Place& a, const Place& b);

}  // namespace quadrat::breeding
