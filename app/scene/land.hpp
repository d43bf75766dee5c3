// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh.hpp"
#include "scene/ground_colours.hpp"
#include "scene/settlement.hpp"

namespace quadrat::scene {

// A way made for feet and wheels; its ground is already levelled to it.
struct Road {
    std::vector<glm::vec3> line_m;  // its middle, a few metres from point to point, on the ground
    float width_m = 4;
    float grade = 0.1F;    // rise over run that it nowhere passes
    bool is_lane = false;  // of a settlement
};

// Level ground kept for a settlement; a road leads to it where the land lets one.
struct Site {
    glm::vec3 middle_m{0};
    float radius_m = 40;
};

// Bare stone that no heightfield can hold: arches, overhangs. Closed meshes that reach into the ground.
struct Stone {
    mesh::Mesh mesh;
    std::vector<glm::vec3> colours;  // linear, one a vertex
};

// Something that a walker would go to see: a cave, an arch, a ring of stones.
struct Landmark {
    glm::vec3 at_m{0};       // the middle of it, over the ground
    glm::vec2 faces{0, 1};   // unit, level: where one stands to see it best
    float size_m = 10;       // its height or breadth, the larger
    bool has_front = false;  // only from there: a cave
};

// World: x east, y up, z south, in metres; the land's middle is x = z = 0, the sea's surface y = 0.
// A point (x, z) lies at column x / cell_m + (columns - 1) / 2, row z / cell_m + (rows - 1) / 2.
struct Land {
    mesh::Field height_m;  // square, 2^k + 1 samples a side
    float cell_m = 2;
    mesh::Field surround_m;      // the country around it to the horizon, coarse, about the same middle; within the
    float surround_cell_m = 64;  // land's own square it lies below the land's surface and is not drawn
    mesh::Field water_m;  // the surface of lakes and rivers at each sample; kNoWater where there is none; may be empty
    mesh::Mesh fresh_water;  // that surface, drawn; it ends under its banks; without normals; texcoords: the
                             // current, m/s east and south
    GroundColours albedo;    // what the ground is made of, over the land's square
    mesh::Image detail;  // tileable, mean 128: the grain of soft ground (grass, earth) and of stone, a channel each;
                         // one channel: the same for both
    mesh::Image detail_slopes;  // their slopes: soft east, south, stone east, south; 128 is level, 255 is 1; or empty
    mesh::Image
        kinds;  // two channels, a pixel a sample: how far its grain is soft ground's, how far stone's; empty: soft
    mesh::Image surround_albedo;  // RGBA, a pixel a sample of surround_m; empty: far_colour
    float detail_tile_m = 7;      // one tile of it on the ground
    mesh::Image lichen;  // tileable, two channels, how far a pale crust and an orange one cover stone; empty: none
    glm::vec3 shallow_colour{0.2F, 0.45F, 0.42F};  // of water, linear
    glm::vec3 deep_colour{0.02F, 0.10F, 0.14F};
    glm::vec3 far_colour{0.3F, 0.35F, 0.25F};  // of the surround as a whole, linear
    float ripple = 0.5F;                       // of its water: 0 a mirror whatever the wind to 1 broken by any
    float snow_line_m = 1.0e6F;                // above the sea: from there upward snow lies

    std::vector<Road> roads;
    std::optional<Site> site;
    mesh::Grid<std::uint8_t> kept_clear;  // a byte a sample: how far the edge of the nearest road or site is, see
                                          // kept_clear_of(); empty: none
    Stone stone;
    Settlement settlement;
    std::vector<Landmark> landmarks;  // the most worth a look first

    float side_m() const { return cell_m * static_cast<float>(height_m.columns - 1); }
};

inline constexpr float kNoWater = -1.0e6F;
inline constexpr float kFarFromRoads_m = 24.0F;

// Land::kept_clear of metres from each sample to that edge, less than 0 on roads and sites: in eighths of a metre,
// rounded toward the road, 255 for kFarFromRoads_m and more.
mesh::Grid<std::uint8_t> kept_clear_of(const mesh::Field& to_edge_m);

// How far a place lies from the edge of the nearest road or site, so that nothing is planted on it; less than 0: on it.
float to_road_m(const Land& land, glm::vec2 at_m);

// The level of the lake or river whose sample is nearest, or of the sea, which is 0; the ground may lie over it.
float water_surface_m(const Land& land, glm::vec2 at_m);

// Depth of water over the ground, of the sea, a lake or a river; 0 on dry land.
float water_depth_m(const Land& land, glm::vec2 at_m);

// Height of the ground above the sea's surface. Outside the land: of the surround, then of its nearest edge.
float ground_height_m(const Land& land, glm::vec2 at_m);

// Unit normal by central differences over one cell.
glm::vec3 ground_normal(const Land& land, glm::vec2 at_m);

}  // namespace quadrat::scene
