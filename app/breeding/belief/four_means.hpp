// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <span>

#include "base/seed.hpp"
#include "breeding/belief/wish.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

using FourPlaces = std::array<Place, genome::kCandidates>;

// The four places that leave the least mean squared distance to the nearest of them (Lloyd 1982, begun by farthest
// points): what to show so that whatever the wish is, one of the four is near it. At least four samples.
FourPlaces four_means(std::span<const Place> samples);

// Indices of the places in an order in which each is farthest from those before it, begun by `first`.
std::vector<std::size_t> farthest_first(std::span<const Place> places, std::size_t first, std::size_t count);

// Indices of `count` places well apart, of which each has nearly the same chance: the first is drawn from all, each
// next from that half of the others that is farther from those drawn. The farthest of all would be the same few
// extremes again and again. At least twice as many places as asked for.
std::vector<std::size_t> drawn_apart(std::span<const Place> places, std::size_t count, base::RandomStream& chance);

double squared_distance(const Place& a, const Place& b);

}  // namespace quadrat::breeding
