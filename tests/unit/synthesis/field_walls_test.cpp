// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "genome/recipe.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

struct Walls {
    scene::Land land;
    std::vector<glm::vec3> corners_m;  // three a facet

    glm::vec2 plan(std::size_t i) const { return {corners_m[i].x, corners_m[i].z}; }
    float over_m(std::size_t i) const { return corners_m[i].y - scene::ground_height_m(land, plan(i)); }
    float area_m2() const {
        float sum = 0;
        for (std::size_t i = 0; i < corners_m.size(); i += 3)
            sum += 0.5F * glm::length(glm::cross(corners_m[i + 1] - corners_m[i], corners_m[i + 2] - corners_m[i]));
        return sum;
    }
};

std::vector<glm::vec3> facets_of(const scene::Land& land) {
    std::vector<glm::vec3> corners_m;
    for (const std::uint32_t index : land.stone.mesh.indices) corners_m.push_back(land.stone.mesh.positions_m[index]);
    return corners_m;
}

// What stands on a land with walls and not on the same without.
Walls walls_of(std::uint64_t seed, const auto& change) {
    scene::SceneParameters p = scene::realise(genome::random_recipe(base::Seed{seed}).values);
    p.land.land_sea_level = 0.05F;
    p.land.land_relief_m = std::min(p.land.land_relief_m, 120.0F);
    p.land.settle_age = seed % 2 == 0 ? 0.4F : -1.0F;
    p.land.wall_share = -1;
    p.land.ledge_share = -1;
    const scene::Fineness coarse{.land_samples = 257, .light_px = 64, .albedo_px = 64};
    const base::Seed chance = base::Seed{seed}.child("land");
    const auto key = [](const glm::vec3& p_m) { return std::array{p_m.x, p_m.y, p_m.z}; };
    std::vector<std::array<float, 3>> before;
    for (const glm::vec3& corner_m : facets_of(grow_land(p.land, chance, coarse))) before.push_back(key(corner_m));
    std::ranges::sort(before);
    p.land.wall_share = 1;
    change(p.land);
    Walls walls{grow_land(p.land, chance, coarse), {}};
    const std::vector<glm::vec3> all = facets_of(walls.land);
    for (std::size_t i = 0; i + 2 < all.size(); i += 3)
        if (!std::ranges::binary_search(before, key(all[i])))
            walls.corners_m.insert(walls.corners_m.end(), {all[i], all[i + 1], all[i + 2]});
    return walls;
}

TEST(FieldWalls, StandOnDryGroundOffRoadsAndHouses) {
    int lands = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Walls walls = walls_of(seed, [](scene::LandParameters& p) { p.wall_height_m = 1.3F; });
        lands += walls.corners_m.size() > 900;
        EXPECT_LT(walls.corners_m.size() / 3, 7000U) << seed;
        for (std::size_t i = 0; i < walls.corners_m.size(); ++i) {
            ASSERT_LT(walls.over_m(i), 1.3F * 1.1F + 0.4F) << seed;
            ASSERT_GT(walls.over_m(i), -1.0F) << seed;
            ASSERT_LE(scene::water_depth_m(walls.land, walls.plan(i)), 0.2F) << seed;
            for (const scene::House& house : walls.land.settlement.houses)
                ASSERT_GT(scene::to_house_m(walls.land.settlement.buildings[house.building], house, walls.plan(i)), 0);
            for (const scene::Road& road : walls.land.roads)
                for (const glm::vec3& r : road.line_m)
                    ASSERT_GT(glm::length(glm::vec2{r.x, r.z} - walls.plan(i)), 0.5F * road.width_m) << seed;
        }
    }
    EXPECT_GE(lands, 4) << "of lands with room for fields";
}

TEST(FieldWalls, FallAsTheyAge) {
    float whole_m2 = 0;
    float fallen_m2 = 0;
    float tall_m2 = 0;
    for (const std::uint64_t seed : {1U, 3U, 5U}) {
        whole_m2 += walls_of(seed, [](scene::LandParameters& p) { p.wall_decay = 0, p.wall_height_m = 1; }).area_m2();
        fallen_m2 += walls_of(seed, [](scene::LandParameters& p) { p.wall_decay = 1, p.wall_height_m = 1; }).area_m2();
        tall_m2 += walls_of(seed, [](scene::LandParameters& p) { p.wall_decay = 0, p.wall_height_m = 1.6F; }).area_m2();
    }
    EXPECT_LT(fallen_m2, 0.7F * whole_m2);
    EXPECT_GT(tall_m2, 1.2F * whole_m2);
}

}  // namespace
