// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "base/seed.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// Space colonisation (Runions, Lane & Prusinkiewicz, "Modeling trees with a space colonization algorithm", 2007): limbs
// grow toward points that stand for room with light, and use them up. A tree of height 1.
struct Colonisation {
    float crown_base = 0.25F;  // height where the crown begins
    float crown_radius = 0.35F;
    float widest = 0.4F;   // where in the crown, 0 its base to 1 its top
    float roundness = 2;   // of the outline: 1 a double cone, 2 an ellipse, more: boxy
    float hollow = 0.45F;  // points keep to the crown's outside by so much
    int points = 620;
    float step = 0.022F;
    float kill = 0.055F;      // a point this near is used up
    float influence = 0.30F;  // points farther away are not seen
    float rise = 0.1F;        // tropism: up or, less than 0, down
    float gnarl = 0.1F;
    std::size_t most_nodes = 3000;
    // What takes the light away: neighbours' crowns (xyz middle, w radius), and ground that rises: height of the ground
    // is dot(slope, xz); points lower than clearance over it get none.
    std::span<const glm::vec4> neighbours;
    glm::vec2 slope{0};
    float clearance = 0.04F;
};

TreeSkeleton colonise(const Colonisation& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::trees
