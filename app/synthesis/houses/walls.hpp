// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/building.hpp"

// Not for use from outside.
namespace quadrat::synthesis::houses {

inline constexpr std::size_t kLevels = 3;

// One side of a building, seen from outside: along from its left lower corner.
struct Side {
    glm::vec3 corner_m{0};
    glm::vec3 along{1, 0, 0};
    glm::vec3 out{0, 0, 1};
    double width_m = 8, height_m = 3;
    std::vector<glm::dvec2> gable;  // its outline over that, from right to left; empty: none
    std::vector<FacadeShape::Covered> covered;
    bool is_front = true;  // only there are doors
};
// Climbers up a finished building's walls, as far as it is overgrown; they leave windows and doors free.
void add_climbers(scene::Building& to, const Design& design, base::Seed seed);

void add_side(scene::Building& to, const Design& design, const Side& side, base::Seed seed);

}  // namespace quadrat::synthesis::houses
