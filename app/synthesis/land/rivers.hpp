// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/mesh.hpp"

namespace quadrat::synthesis::land {

// What becomes of hollows that no river runs through: lakes or level ground, or, in sand, dry hollows as they are.
enum class Hollows { Settle, Seep };

struct FreshWaterOptions {
    float sea_m = 0;
    float river_area_m2 = 45000;  // drained area from which on a stream is a river
    float lake_depth_m = 1.2F;    // shallower hollows are filled with earth
    float lake_area_m2 = 500;     // and so are smaller ones
    float width = 1;              // of rivers, to what their water asks for
    float depth = 1;
    float fall_m = 4;  // height of a waterfall, where a bed drops steeply enough to have one
    Hollows hollows = Hollows::Settle;
};

// Lakes and rivers. Surfaces never rise downstream, lakes are level, and every wet cell has a wet way down to the sea,
// the border, or through a lake on.
enum class Wet : std::uint8_t { No, Lake, River };

struct FreshWater {
    mesh::Field surface_m;  // scene::kNoWater where there is none
    mesh::Grid<Wet> kind;
    mesh::Mesh mesh;                     // over the wet cells and one beyond
    std::vector<float> drained_area_m2;  // of the ground before rivers were carved
};

// Fills small hollows, carves beds and banks into the ground, and tells where water stands and runs.
FreshWater make_fresh_water(mesh::Field& height_m, float cell_m, const FreshWaterOptions& options);

// How high each sample stands over the sea, or over the lake or river that it lies beside.
mesh::Field height_over_water_m(const mesh::Field& height_m, const FreshWater& water);

}  // namespace quadrat::synthesis::land
