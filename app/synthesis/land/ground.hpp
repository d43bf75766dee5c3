// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "scene/parameters.hpp"

namespace quadrat::synthesis::land {

// What a country is made of, linear colours chosen together.
struct Palette {
    glm::vec3 lush, dry, heath;       // what grows on it: hollows, ridges, patches
    glm::vec3 soil, scree;            // steeper
    glm::vec3 rock_light, rock_dark;  // strata
    glm::vec3 sand, snow;
    glm::vec3 shallow, deep;  // water
};

// Between two of the hand-chosen countries, by seed; rugged land leans toward stone.
Palette choose_palette(const scene::LandParameters& parameters, base::Seed seed);

// The ground's colour over the land's square, alpha: wetness. over_water_m: height over the nearest water's surface.
mesh::Image ground_albedo(const mesh::Field& height_m, const mesh::Field& over_water_m, float cell_m,
                          const Palette& palette, const scene::LandParameters& parameters, base::Seed seed,
                          int side_px);

// The ground's grain: one channel, tileable, mean 128.
mesh::Image ground_detail(base::Seed seed, int side_px, float contrast);

}  // namespace quadrat::synthesis::land
