// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <span>

#include "breeding/belief/four_means.hpp"
#include "breeding/belief/wish.hpp"

namespace quadrat::breeding {

// What is believed of the wish in one aspect: two priors side by side, weighted by how well they foretold the picks, so
// that a prior that does not suit this visitor costs little. Knowing archetypes is optional.
struct AspectBelief {
    Wish isotropic;
    std::optional<Wish> near_archetypes;
    std::optional<std::size_t> winner;  // of the four last shown, the one that was named best
    FourPlaces shown;                   // what was last judged; empty places before the first pick
    friend bool operator==(const AspectBelief&, const AspectBelief&) = default;

    double isotropic_share() const;  // its weight, in [0, 1]
    Place mean() const;              // where the wish is expected, in [0, 1]
    Place deviation() const;         // a coordinate; of the mixture
};

AspectBelief initial_belief(std::size_t dimensions, std::span<const Place> archetypes);

AspectBelief learnt(AspectBelief belief, const FourPlaces& shown, std::size_t picked);

// The next four: the archetypes farthest from one another at first; then the centroids of what the wish may be, spread
// a little outward, the last winner staying where it was in the place of the one nearest to it; and a runner-up that is
// more plausible than what would replace it.
FourPlaces proposed(const AspectBelief& belief, std::span<const Place> archetypes, base::Seed seed);

}  // namespace quadrat::breeding
