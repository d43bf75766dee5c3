// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"

namespace quadrat::synthesis::sky {

struct CloudShape {
    int side_px = 512;  // a power of two
    int masses = 3;     // of the largest clouds across a tile
    int octaves = 6;
    float gain = 0.52F;   // amplitude of an octave to the one before
    float billow = 0.3F;  // 0 wisps to 1 heaps
    float clumps = 0.3F;  // 0 even to 1: bare here, closed there
    float cover = 0.45F;  // share of the tile under cloud: 0 clear to 1 overcast
    float sharpness = 0.5F;
    float thickness = 0.6F;  // 0 to 1
};

struct CloudImages {
    mesh::Image density;
    mesh::Image lit;
    float mean_density = 0;  // 0 to 1
    float mean_lit = 0;      // weighted by density
};

// Optical depth of cloud over each point of the tile, 0 where there is none.
mesh::Field cloud_depth(const CloudShape& shape, base::Seed seed);
// That seen from below, lit by a short march through the layer toward the sun.
CloudImages light_clouds(const mesh::Field& depth, const CloudShape& shape, const glm::vec3& sun);

// Tileable fBm through the cover and sharpness filter, then lit by a short march through the layer toward the sun.
// sun: unit, in the tile's own ways (x across, z along), y up.
CloudImages make_clouds(const CloudShape& shape, const glm::vec3& sun, base::Seed seed);

}  // namespace quadrat::synthesis::sky
