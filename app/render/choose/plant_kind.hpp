// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::render::choose {

// What choosing the detail of a species needs to know of it.
struct PlantKind {
    float height_m = 1;
    float radius_m = 1;                       // of a cylinder about the stem that holds all of it
    std::vector<std::size_t> wood_triangles;  // a level, finest first
    std::vector<float> wood_left_out_m;       // the same: scene::Wood
    std::size_t blades = 0;
    std::size_t triangles_per_blade = 0;
    std::size_t triangles_per_plain_blade = 0;  // 0: there is no plain form
    float blade_m = 0.3F;
    std::vector<std::size_t> mass_triangles = {};  // of the crown as one mass, a level, finest first
    float massed = 0;                              // of its leaves, the share that this stands for
    float largest_blade = 100;                     // times its size; beyond it the crown thins instead
    float crown_m = 1;                             // the radius of its crown, but for what stands out of it
    float opacity = 0;                             // of the crown, of what lies behind it: 0 to 1
    float trunk_m = 0.2F;                          // its radius
    std::size_t copies = 1;                        // each blade may be drawn so often, smaller, near by
    bool are_slivers = false;                      // its blades: limbs and twigs of a leafless crown
};

PlantKind plant_kind_of(const scene::Species& species);

}  // namespace quadrat::render::choose
