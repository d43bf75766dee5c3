// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/flora.hpp"
#include "synthesis/compose/site.hpp"
#include "synthesis/compose/storeys.hpp"

// Which kind of plant grows where one can.
namespace quadrat::synthesis {

// One of the kinds by its share and how well it does, drawn by an own number of the place. best: of the best of them.
// zone: where it lies, for kinds that keep to one.
template <typename Well>
std::uint32_t choose_species(const scene::Flora& flora, std::span<const std::uint32_t> kinds, float draw,
                             const Well& well, float& best, const Zone* zone = nullptr) {
    constexpr std::size_t kMost = 12;
    float weights[kMost] = {};
    float total = 0;
    best = 0;
    const std::size_t count = std::min(kinds.size(), kMost);
    for (std::size_t i = 0; i < count; ++i) {
        const float w = well(kinds[i], i);
        best = std::max(best, w);
        weights[i] = w * flora.species[kinds[i]].share;
        if (zone != nullptr) weights[i] *= at_home(flora.species[kinds[i]], *zone);
        total += weights[i];
    }
    float left = draw * total;
    for (std::size_t i = 0; i < count; ++i) {
        left -= weights[i];
        if (left <= 0 && weights[i] > 0) return kinds[i];
    }
    return kinds[count - 1];
}

// Below this value lies such a share of the fBm used here (a normal distribution's, nearly).
inline float quantile(float share) {
    const float s = std::clamp(share, 0.001F, 0.999F);
    return 0.20F * std::log(s / (1 - s)) / 1.702F;
}

}  // namespace quadrat::synthesis
