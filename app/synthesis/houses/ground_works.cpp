// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/settle.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kOverWater_m = 0.3F;
constexpr float kPadRoom_m = 0.9F;  // level ground around the walls
constexpr float kPadEase_m = 5.0F;  // over which it meets the land
constexpr float kLaneEase_m = 3.0F;

glm::vec3 roof_colour(const scene::Building& building) {
    const scene::Masses& masses = building.levels.back();
    for (std::size_t i = 0; i < masses.claddings.size(); ++i)
        if (masses.claddings[i] >= scene::Cladding::Tiles) return masses.colours[i];
    return kSnow;
}

float smooth(float t) {
    t = std::clamp(t, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

// visit(height, place) of each sample within a reach of a place.
template <typename Visit>
void for_samples(scene::Land& land, glm::vec2 at, float reach_m, const Visit& visit) {
    mesh::Field& h = land.height_m;
    const float half = 0.5F * static_cast<float>(h.columns - 1);
    const auto first = [&](float m) { return static_cast<int>(std::floor((m - reach_m) / land.cell_m + half)); };
    const auto last = [&](float m) { return static_cast<int>(std::ceil((m + reach_m) / land.cell_m + half)); };
    for (int y = std::max(first(at.y), 0); y <= std::min(last(at.y), h.rows - 1); ++y)
        for (int x = std::max(first(at.x), 0); x <= std::min(last(at.x), h.columns - 1); ++x)
            visit(h.at(x, y), land.cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half));
}

// Across a lane the ground is level, along it even.
void level_lane(scene::Land& land, const Lane& lane) {
    std::vector<float> heights;
    for (const glm::vec2 p : lane.line_m) heights.push_back(scene::ground_height_m(land, p));
    std::vector<bool> is_over_water(heights.size(), false);
    for (const Lane::Crossing& crossing : lane.crossings)
        for (std::size_t i = crossing.from; i < crossing.to; ++i) {
            const float t = static_cast<float>(i - crossing.from) / static_cast<float>(crossing.to - crossing.from);
            heights[i] = heights[crossing.from] + t * (heights[crossing.to] - heights[crossing.from]);
            is_over_water[i] = true;
        }
    for (int round = 0; round < 3; ++round) {
        std::vector<float> even = heights;
        for (std::size_t i = 1; i + 1 < heights.size(); ++i)
            even[i] = 0.25F * heights[i - 1] + 0.5F * heights[i] + 0.25F * heights[i + 1];
        heights = std::move(even);
    }
    const float half_m = 0.5F * lane.width_m + 0.4F;
    for (std::size_t i = 0; i + 1 < lane.line_m.size(); ++i) {
        if (is_over_water[i]) continue;
        const glm::vec2 a = lane.line_m[i];
        const glm::vec2 d = lane.line_m[i + 1] - a;
        const float length2 = glm::dot(d, d);
        for_samples(land, a + 0.5F * d, half_m + kLaneEase_m + 0.5F * std::sqrt(length2), [&](float& h, glm::vec2 p) {
            const float t = std::clamp(glm::dot(p - a, d) / length2, 0.0F, 1.0F);
            const float share = 1 - smooth((glm::distance(p, a + t * d) - half_m) / kLaneEase_m);
            h += 0.8F * share * (heights[i] + t * (heights[i + 1] - heights[i]) - h);
        });
    }
}

// Where the ground of several houses meets, each has the more say the nearer it is.
void level_pads(scene::Land& land, const scene::Settlement& settlement) {
    mesh::Field weight(land.height_m.columns, land.height_m.rows, 0.0F);
    mesh::Field wished = weight;
    mesh::Field share = weight;
    for (const scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        const float reach_m = glm::length(building.half_m) + kPadRoom_m + kPadEase_m;
        const scene::HouseFrame frame(building, house);
        for_samples(land, {house.foot_m.x, house.foot_m.z}, reach_m, [&](const float& h, glm::vec2 p) {
            const auto i = static_cast<std::size_t>(&h - land.height_m.samples.data());
            const float its = 1 - smooth((frame.away_m(p) - kPadRoom_m) / kPadEase_m);
            const float says = its / (1.001F - its);
            weight.samples[i] += says;
            wished.samples[i] += says * house.foot_m.y;
            share.samples[i] = std::max(share.samples[i], its);
        });
    }
    for (std::size_t i = 0; i < weight.samples.size(); ++i) {
        if (weight.samples[i] <= 0) continue;
        float& h = land.height_m.samples[i];
        h += share.samples[i] * (wished.samples[i] / weight.samples[i] - h);
    }
}

}  // namespace

// On all roofs of a village or on none, by the one that lies in the middle: neighbours have one weather.
void cover_with_snow(scene::Settlement& settlement, float snow_line_m) {
    if (settlement.houses.empty()) return;
    std::vector<float> feet_m;
    for (const scene::House& house : settlement.houses) feet_m.push_back(house.foot_m.y);
    const auto middle = feet_m.begin() + static_cast<std::ptrdiff_t>(feet_m.size() / 2);
    std::ranges::nth_element(feet_m, middle);
    if (*middle <= snow_line_m) return;
    for (scene::House& house : settlement.houses)
        house.roof_tint *= kSnow / roof_colour(settlement.buildings[house.building]);
}

void level_ground(scene::Land& land, Settled& settled) {
    for (const Lane& lane : settled.lanes) level_lane(land, lane);
    scene::Settlement& settlement = settled.settlement;
    for (scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        float sum = 0;
        float high = -1.0e9F;
        const std::vector<glm::vec2> corners = outline_m(building, house, 0);
        for (const glm::vec2 p : corners) {
            const float h = scene::ground_height_m(land, p);
            sum += 0.25F * h;
            high = std::max(high, h);
        }
        house.foot_m.y = sum + 0.3F * (high - sum);
        // Ground that is made level must not sink below the water beside it.
        for (const glm::vec2 p : along_outline_m(building, house, kPadRoom_m + land.cell_m, land.cell_m))
            house.foot_m.y = std::max(house.foot_m.y, scene::water_surface_m(land, p) + kOverWater_m);
    }
    cover_with_snow(settlement, land.snow_line_m);
    level_pads(land, settlement);
}

}  // namespace quadrat::synthesis::houses
