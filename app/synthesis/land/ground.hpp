// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "scene/parameters_fwd.hpp"

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

// What the look of the ground hangs on besides its shape; fields of the land's samples.
struct GroundFacts {
    const mesh::Field& height_m;
    const mesh::Field& over_water_m;  // height over the nearest water's surface
    const mesh::Field& moisture;      // 0 dry to 1 where water gathers
    const mesh::Field& to_road_m;     // to the edge of the nearest road; empty: none
    float cell_m;
};

struct Ground {
    mesh::Image albedo;  // RGBA, colour; alpha: wetness
    mesh::Image kinds;   // scene::Land::kinds
};

// How rock, scree, soil, grass, heath, sand, snow and mud lie, by slope, height, curvature, moisture and aspect, and
// what colour that gives.
Ground lay_ground(const GroundFacts& facts, const Palette& palette, const scene::LandParameters& parameters,
                  base::Seed seed, int side_px);

// By how much water comes together here and how slowly it leaves (Beven & Kirkby 1979, ln a / tan b), 0 to 1.
mesh::Field moisture_of(const mesh::Field& height_m, const std::vector<float>& drained_area_m2, float cell_m);

// See scene::Land::detail and detail_slopes.
struct GroundDetail {
    mesh::Image grain;
    mesh::Image slopes;
};
struct DetailLook {
    float contrast = 1, bumps = 1;
    float sandy = 0;    // 0 to 1, how far soft ground is ripples of sand instead of tufts
    float cracked = 0;  // 0 to 1, how far it is plates of dry mud
};
GroundDetail ground_detail(base::Seed seed, int side_px, const DetailLook& look);

// Mud that has dried, as the relief of one tile: plates some tenth of it wide, about 0.5 high, and cracks below -1.
mesh::Field mud_tile(base::Seed seed, int side_px);

// Colours of the country around, a pixel a sample, sRGB.
mesh::Image surround_colours(const mesh::Field& surround_m, float cell_m, const Palette& palette,
                             const scene::LandParameters& parameters, base::Seed seed);

// Where the country around meets the land it has the land's colours, and its own some hundred metres out: what lies in
// two pictures is painted by one hand. surround: as surround_colours() made it; albedo: of the land.
void ease_into_land(mesh::Image& surround, float cell_m, const mesh::Image& albedo, float side_m);

// Height above the sea from which snow lies; far above everything where none does.
float snow_line_m(const scene::LandParameters& parameters);
// How far what lies dry has cracked: 0 to 1.
float cracked(const scene::LandParameters& parameters);
// How far land is dunes, and so bare sand: 0 to 1.
float sandy(const scene::LandParameters& parameters);

}  // namespace quadrat::synthesis::land
