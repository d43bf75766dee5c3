// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "genome/recipe.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

scene::LandParameters parameters_of(std::uint64_t seed) {
    scene::LandParameters p = scene::realise(genome::random_recipe(base::Seed{seed}).values).land;
    p.land_sea_level = 0.1F;
    p.land_relief_m = std::min(p.land_relief_m, 140.0F);
    p.settle_age = -1;
    p.arch_share = -1;
    p.wall_share = -1;
    p.ledge_share = -1;
    p.site_share = seed % 2 == 0 ? 0.5F : -1.0F;
    return p;
}

scene::Land grown(const scene::LandParameters& p, std::uint64_t seed) {
    return grow_land(p, base::Seed{seed}.child("land"), {.land_samples = 257, .light_px = 64, .albedo_px = 64});
}

// What of a land's stone stands more than a metre over the ground within their reach, square metres.
float standing_m2(const scene::Land& land) {
    const glm::vec2 middle{land.landmarks.back().at_m.x, land.landmarks.back().at_m.z};
    const mesh::Mesh& mesh = land.stone.mesh;
    float sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<glm::vec3, 3> at{};
        for (std::size_t c = 0; c < 3; ++c) at[c] = mesh.positions_m[mesh.indices[i + c]];
        const glm::vec2 plan{at[0].x, at[0].z};
        if (glm::length(plan - middle) > 35 || at[0].y < scene::ground_height_m(land, plan) + 1) continue;
        sum += 0.5F * glm::length(glm::cross(at[1] - at[0], at[2] - at[0]));
    }
    return sum;
}

class RockLedges : public testing::TestWithParam<float> {};  // of which kind

TEST_P(RockLedges, StandsOnLandThatHasRoomForIt) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        scene::LandParameters p = parameters_of(seed);
        const std::size_t before = grown(p, seed).stone.mesh.indices.size() / 3;
        p.ledge_share = 1;
        p.ledge_kind = GetParam();
        p.ledge_decay = 0.3F;
        const scene::Land land = grown(p, seed);
        EXPECT_LT(land.stone.mesh.indices.size() / 3, before + 11000) << seed;
        if (land.landmarks.empty()) continue;
        ++found;
        const scene::Landmark& mark = land.landmarks.back();
        EXPECT_FLOAT_EQ(mark.size_m, p.ledge_size_m);
        EXPECT_GT(standing_m2(land), 40) << seed;
        const glm::vec2 middle{mark.at_m.x, mark.at_m.z};
        EXPECT_LE(scene::water_depth_m(land, middle), 0) << seed;
        EXPECT_LT(scene::to_road_m(land, middle), 1) << "nothing is planted in it";
    }
    EXPECT_GE(found, 6);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, RockLedges, testing::Values(0.0F, 1.0F));

// The highest of a land's stone over its foot, within their reach.
float highest_m(const scene::Land& land) {
    const scene::Landmark& mark = land.landmarks.back();
    float most = 0;
    for (const glm::vec3& p : land.stone.mesh.positions_m)
        if (glm::length(glm::vec2{p.x - mark.at_m.x, p.z - mark.at_m.z}) < 0.5F * mark.size_m)
            most = std::max(most, p.y - scene::ground_height_m(land, {mark.at_m.x, mark.at_m.z}));
    return most;
}

// Tiles fill a square; rock does not.
TEST(ALedge, HasWeatheredToARound) {
    int ledges = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        scene::LandParameters p = parameters_of(seed);
        p.ledge_share = 1;
        p.ledge_decay = 0;
        const scene::Land land = grown(p, seed);
        if (land.landmarks.empty()) continue;
        ++ledges;
        const scene::Landmark& mark = land.landmarks.back();
        int within = 0;
        int corners = 0;
        for (const glm::vec3& point : land.stone.mesh.positions_m) {
            const glm::vec2 at{point.x, point.z};
            const float away = glm::distance(at, glm::vec2{mark.at_m.x, mark.at_m.z}) / mark.size_m;
            if (point.y < scene::ground_height_m(land, at) + 0.5F) continue;
            within += away < 0.55F;
            corners += away > 0.57F && away < 0.65F;
        }
        EXPECT_LT(corners, 0.01F * static_cast<float>(within)) << seed;
    }
    EXPECT_GE(ledges, 4);
}

TEST(ALedge, IsLowerTheMoreItHasWornAway) {
    float whole_m = 0;
    float worn_m = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        scene::LandParameters p = parameters_of(seed);
        p.ledge_share = 1;
        p.ledge_kind = 1;
        for (const float decay : {0.0F, 1.0F}) {
            p.ledge_decay = decay;
            const scene::Land land = grown(p, seed);
            if (!land.landmarks.empty()) (decay > 0 ? worn_m : whole_m) += highest_m(land);
        }
    }
    EXPECT_LT(worn_m, 0.75F * whole_m);
}

}  // namespace
