// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "mesh/image.hpp"

namespace quadrat::synthesis::sky {

struct CloudShape {
    int side_px = 512;
    int masses = 3;  // of the largest clouds across a tile
    int octaves = 6;
    float cover = 0.45F;  // 0 clear to 1 overcast
    float sharpness = 0.5F;
};

struct CloudImages {
    mesh::Image density;
    mesh::Image lit;
};

// Tileable fBm through the cover and sharpness filter, then lit by a short march toward the sun through the layer.
CloudImages make_clouds(const CloudShape& shape, const glm::vec3& sun_direction, base::Seed seed);

}  // namespace quadrat::synthesis::sky
