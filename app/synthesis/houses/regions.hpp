// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "scene/settlement.hpp"

// Not for use from outside.
namespace quadrat::synthesis::houses {

// How a region builds. Metres, degrees, sRGB.
struct Region {
    std::string_view dwelling, townhouse;  // façades
    scene::Cladding wall, lower;
    float wall_m;    // of the usual house
    float storey_m;  // one more, or one less where it is higher than two
    float pitch_deg, eave_m, verge_m, hipped;
    scene::Cladding roof;
    std::array<std::uint32_t, 3> roofs;  // plainer, usual, warmer
    std::uint32_t plinth, wood;
    float depth_m, width_m;
    float plinth_m, chimneys;
    float broken;  // share of mansard and gambrel roofs
};

// Of that number, from 0 to kRegions - 1.
const Region& region(int number);
// The Atlantic's where it roofs with thatch.
const Region& thatched_region();

}  // namespace quadrat::synthesis::houses
