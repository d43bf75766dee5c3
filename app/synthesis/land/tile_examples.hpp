// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>

#include "mesh/mesh.hpp"
#include "synthesis/noise/model_synthesis.hpp"

namespace quadrat::synthesis::land {

// Examples that tiles are made after: "ruin", walls and columns that have fallen in part, and "terraces", stepped rock.
struct TileExample {
    std::string_view name;
    std::string_view meaning;
    std::string_view text;  // as noise::tiles_from reads it
};
std::span<const TileExample> tile_examples();

// How likely its kinds are, by how much has fallen: 0 to 1.
std::vector<noise::Weight> weights_of(const TileExample& example, float decay);

// How tiles look as a solid. Those of the ruin's example have shapes of their own: '-' and '|' walls, 'A' and 'H'
// arches in them, '7', '9', '1' and '3' corners as on a block of numbers, 'w', 'e', 'N' and 'S' ends of walls that have
// broken off to the west and so on, 'o' columns and 'c' what is left of one, ',' paving, 'r' rubble; any other is a
// block. x east, y up, z south, from the middle of the lowest layer's underside.
struct TileShape {
    float side_m = 2.2F;
    float storey_m = 2.4F;
    float sunk_m = 0;  // how far what stands on the ground goes on under it
};
struct TileFacet {
    glm::vec3 corners[3];
    float tint;  // of its stone, about 1
};
std::vector<TileFacet> facets_of(const noise::Tiles& tiles, const TileShape& shape, base::Seed seed);

}  // namespace quadrat::synthesis::land
