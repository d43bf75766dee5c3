// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

#include "synthesis/houses/network.hpp"
#include "synthesis/lsystem/grammar.hpp"

// Parish & Müller's streets. Not for use from outside.
namespace quadrat::synthesis::houses {

struct NamedStreets {
    std::string_view name, text;
};
const std::vector<NamedStreets>& street_library();

// What streets of a pattern strive for, and what the land lets them.
struct StreetRules {
    Streets pattern = Streets::Organic;
    float width_m = 2.6F;
    float winding = 0.6F;   // 0 straight to 1
    float raster_deg = 0;   // of one of its directions, from x toward z
    glm::vec2 middle_m{0};  // of rings and rays
};

// Streets that are there already, as a word's beginning:
//     [M(x,z,heading,width,road)G(5)V(1)+(turn)G(5)V(2)…]      a road of the land, or a street to grow:
//     …R(n,k)?(0,0,0,goal)]
// Derives it by the pattern's grammar until nothing is asked any more. Lanes that lead nowhere and are short are left
// out.
std::vector<Branch> grow_streets(const scene::Land& land, const StreetRules& rules, const lsystem::Word& beginning,
                                 base::Seed seed);

}  // namespace quadrat::synthesis::houses
