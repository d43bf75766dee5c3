// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "scene/land.hpp"

namespace quadrat::synthesis::houses {

// A street to build along: points a step apart, outward from the settlement's middle; the last may be nearer.
struct Lane {
    std::vector<glm::vec2> line_m;
    float width_m = 2.6F;
    bool is_road = false;  // of the land: it is there already
    struct Crossing {
        std::size_t from = 0, to = 0;  // points, on dry land; all between them lie in water
    };
    std::vector<Crossing> crossings;
};
inline constexpr float kLaneStep_m = 5;

// Ground that one could build on: dry, over the sea and not at the land's edge.
bool is_buildable(const scene::Land& land, glm::vec2 at_m);
float steepness(const scene::Land& land, glm::vec2 at_m, float over_m = 6);  // rise over run

}  // namespace quadrat::synthesis::houses
