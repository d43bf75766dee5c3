// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/hero_place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "synthesis/compose/planting.hpp"
#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {
namespace {

scene::Land plain() {
    scene::Land land;
    land.height_m = mesh::Field(129, 129, 2.0F);
    land.cell_m = 8;
    return land;
}

const FlightPlan kNorthward{{{{0, 60}, {0, -1}}}};

scene::Track from(float over_m) { return {{{{0, 2 + over_m, 60}, {0, 2 + over_m - 6, -40}, 42}}, 80}; }

TEST(InPicture, HasItsMiddleAheadAndItsEdgesWhereRaysEnd) {
    const scene::Camera camera{{3, 5, 7}, {3, 5, -93}, 42};
    EXPECT_NEAR(in_picture(camera, {3, 5, -20})->x, 0, 1e-5F);
    EXPECT_NEAR(in_picture(camera, {3, 5, -20})->y, 0, 1e-5F);
    EXPECT_FALSE(in_picture(camera, {3, 5, 20}));
    const float up_m = 10 * std::tan(0.5F * 42 * 0.0174533F);
    EXPECT_NEAR(in_picture(camera, {3, 5 + up_m, -3})->y, 1, 1e-4F);
    EXPECT_NEAR(in_picture(camera, {3 - up_m * 16 / 9, 5, -3})->x, -1, 1e-4F);
}

// On a third, and neither its foot nor its top cut off wherever a place allows it.
TEST(HeroPlace, ShowsATreeWholeFromAnyHeight) {
    const scene::Land land = plain();
    int cut_without_asking = 0;
    for (int i = 0; i < 60; ++i) {
        const float high_m = 4.0F + 0.3F * static_cast<float>(i);
        const float over_m = 2.0F + static_cast<float>(i % 13);
        const scene::Track track = from(over_m);
        const float side = i % 2 == 0 ? -1.0F : 1.0F;
        const auto whole = [&](const std::optional<glm::vec2>& at_m) {
            if (!at_m) return false;
            const std::optional<glm::vec2> foot = in_picture(track.cameras.front(), {at_m->x, 2, at_m->y});
            const std::optional<glm::vec2> top = in_picture(track.cameras.front(), {at_m->x, 2 + high_m, at_m->y});
            return foot && top && foot->y > -1 && top->y < 1 && std::abs(foot->x) < 0.7F && foot->x * side > 0.1F;
        };
        base::RandomStream random{base::Seed{static_cast<std::uint64_t>(i)}};
        base::RandomStream again = random;
        EXPECT_TRUE(whole(hero_place(land, kNorthward, track, high_m, side, random))) << high_m << " from " << over_m;
        if (!whole(hero_place(land, kNorthward, {}, high_m, side, again))) ++cut_without_asking;
    }
    EXPECT_GT(cut_without_asking, 5);
}

TEST(HeroPlace, IsNowhereWhereATreeWouldBeCutOffEverywhere) {
    base::RandomStream random{base::Seed{3}};
    EXPECT_FALSE(hero_place(plain(), kNorthward, from(3), 400, 1, random));
    EXPECT_TRUE(hero_place(plain(), kNorthward, from(3), 12, 1, random));
}

// How many trees stand where only those do that are set for the picture's sake, and how near two of them are.
std::pair<std::size_t, float> set_with(float crown_m, std::uint64_t seed) {
    scene::Land land = plain();
    land.albedo = scene::GroundColours(mesh::Image(64, 64, 4));
    scene::Flora flora;
    scene::Species& tree = flora.species.emplace_back();
    tree.height_m = 12;
    tree.crown_radius_m = crown_m;
    tree.trunk_radius_m = 0.2F;
    tree.moisture_width = 3;
    const FlightPlan flight{{{{0, 60}, {0, -1}}, {{6, 50}, {0, -1}}}};
    const auto plants = plant_land(land, flora, flight, {}, base::Seed{seed}, {.trees = 0, .undergrowth = 0});
    float nearest_m = 1.0e6F;
    for (std::size_t i = 0; i < plants.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            nearest_m = std::min(nearest_m, glm::distance(plants[i].root_m, plants[k].root_m));
    return {plants.size(), nearest_m};
}

TEST(Hero, IsNotAloneWhereItIsAsNarrowAsAPost) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const auto [posts, apart_m] = set_with(0.8F, seed);
        const auto [trees, open_m] = set_with(4, seed);
        EXPECT_GT(posts, trees) << seed;
        EXPECT_LT(apart_m, 6) << seed;
        EXPECT_GT(open_m, 6) << seed;
    }
}

}  // namespace
}  // namespace quadrat::synthesis
