// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "scene/sky.hpp"

namespace quadrat::synthesis::sky {

// A sky of clouds with flat bases at one height and tops over them.
struct CloudscapeShape {
    const mesh::Field& depth;  // cloud_depth(): a tile of optical depths from base to top, a power of two a side
    float tile_m = 4200;       // across
    float stretch = 1;         // of the tile along
    glm::vec2 along{0, -1};    // unit, east and south
    float base_m = 900;        // over the eye
    float tall_m = 500;        // of what is optically deepest
    float gap = 0;             // 0 to 1: how high over the horizon the clouds end, far off, 1: 14 degrees
    float beams = 0;           // strength of the light between them, toward the disc
    float halo = 0;            // of a ring about it
    glm::vec3 light{0, 1, 0};  // toward what lights them, unit
    glm::vec3 disc{0, 1, 0};   // toward the sun or the moon, unit
    base::Seed seed{};         // of their bulges
    float swelling = 0.75F;    // of optical depth, by the largest of them
};

// What share of the sky's light, 0 to 1, is left at this height over the horizon where there is such a gap.
float closed_over_gap(float gap, float sine_of_height);

// Marches outward from the eye through the clouds, and through them toward the light (Kajiya & Von Herzen, "Ray tracing
// volume densities", 1984): sides toward the light are lit, the flat bases dark. width, height: pixels.
scene::Cloudscape make_cloudscape(const CloudscapeShape& shape, int width, int height);

}  // namespace quadrat::synthesis::sky
