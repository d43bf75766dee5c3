// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "genome/recipe.hpp"
#include "scene/camera.hpp"
#include "scene/colour.hpp"
#include "scene/land.hpp"
#include "scene/parameters.hpp"

namespace {

using namespace quadrat;

scene::Land sloping_land() {
    scene::Land land;
    land.cell_m = 2;
    land.height_m = mesh::Field(17, 17);
    for (int row = 0; row < 17; ++row)
        for (int column = 0; column < 17; ++column)
            land.height_m.at(column, row) = 0.5F * 2.0F * static_cast<float>(column - 8);
    land.surround_cell_m = 8;
    land.surround_m = mesh::Field(9, 9, 40.0F);
    return land;
}

TEST(Land, IsAsHighAsItsSamplesAndThenAsItsSurround) {
    const scene::Land land = sloping_land();
    EXPECT_FLOAT_EQ(scene::ground_height_m(land, {0, 0}), 0);
    EXPECT_FLOAT_EQ(scene::ground_height_m(land, {5, -7}), 2.5F);
    EXPECT_FLOAT_EQ(scene::ground_height_m(land, {20, 0}), 40);
    EXPECT_FLOAT_EQ(scene::ground_height_m(land, {1000, 1000}), 40);
}

TEST(Land, HasTheNormalOfItsSlope) {
    const glm::vec3 n = scene::ground_normal(sloping_land(), {1, 2});
    EXPECT_NEAR(glm::length(n), 1, 1e-6);
    EXPECT_NEAR(n.x / n.y, -0.5, 1e-5);
    EXPECT_NEAR(n.z, 0, 1e-6);
}

scene::Track straight_track() {
    scene::Track track;
    track.period_s = 20;
    for (int i = 0; i < 9; ++i) {
        const auto x = static_cast<float>(i);
        track.cameras.push_back({{x, 3, 0}, {x, 3, -10}, 40});
    }
    return track;
}

TEST(Track, GoesThereAndBackAndRestsAtBothEnds) {
    const scene::Track track = straight_track();
    EXPECT_NEAR(scene::camera_at(track, 0).eye_m.x, 0, 1e-5);
    EXPECT_NEAR(scene::camera_at(track, 10).eye_m.x, 8, 1e-4);
    EXPECT_NEAR(scene::camera_at(track, 20).eye_m.x, 0, 1e-4);
    EXPECT_NEAR(scene::camera_at(track, 5).eye_m.x, 4, 1e-3);
    const auto speed = [&](float t) {
        return std::abs(scene::camera_at(track, t + 0.01F).eye_m.x - scene::camera_at(track, t - 0.01F).eye_m.x) /
               0.02F;
    };
    EXPECT_LT(speed(0), 0.02F);
    EXPECT_LT(speed(10), 0.02F);
    EXPECT_GT(speed(5), 1.0F);
}

TEST(Track, NeverJumpsAtAnyTime) {
    const scene::Track track = straight_track();
    for (float t = -45; t < 300; t += 0.05F)
        EXPECT_LT(glm::distance(scene::camera_at(track, t).eye_m, scene::camera_at(track, t + 0.05F).eye_m), 0.1F) << t;
}

TEST(Track, WithoutCamerasGivesTheDefaultOne) { EXPECT_EQ(scene::camera_at({}, 12).eye_m, scene::Camera{}.eye_m); }

TEST(Camera, PutsItsTargetInTheMiddleOfThePicture) {
    const scene::Camera camera{{10, 5, 3}, {-20, 8, -40}, 42};
    const glm::vec4 p =
        scene::clip_from_view(camera, 16.0F / 9.0F) * scene::view_from_world(camera) * glm::vec4(camera.target_m, 1);
    EXPECT_NEAR(p.x / p.w, 0, 1e-4);
    EXPECT_NEAR(p.y / p.w, 0, 1e-4);
    EXPECT_GT(p.w, 0);
}

TEST(Colour, ComesBackFromOklabAndFromSrgb) {
    for (const std::uint32_t hex : {0x000000U, 0xFFFFFFU, 0x6E9440U, 0xC8573FU, 0x1F4F5CU}) {
        const glm::vec3 c = scene::linear_from_srgb_hex(hex);
        EXPECT_LT(glm::distance(scene::linear_from_oklab(scene::oklab_from_linear(c)), c), 2e-5F);
        EXPECT_EQ(scene::srgb_byte(c.x), hex >> 16U);
        EXPECT_EQ(scene::srgb_byte(c.z), hex & 255U);
    }
}

TEST(Colour, WhiteIsOnTheGreyAxisOfOklab) {
    const glm::vec3 lab = scene::oklab_from_linear({1, 1, 1});
    EXPECT_NEAR(lab.x, 1, 1e-4);
    EXPECT_NEAR(lab.y, 0, 1e-4);
    EXPECT_NEAR(lab.z, 0, 1e-4);
}

TEST(Land, KnowsTheWayToARoadToAnEighthOfAMetreAndNeverTooFar) {
    scene::Land land = sloping_land();
    EXPECT_EQ(scene::to_road_m(land, {3, 4}), scene::kFarFromRoads_m) << "none";
    const auto away_m = [](float x_m) { return 1.3F * x_m; };
    mesh::Field to_edge_m(17, 17);
    for (int row = 0; row < 17; ++row)
        for (int column = 0; column < 17; ++column)
            to_edge_m.at(column, row) = away_m(2.0F * static_cast<float>(column - 8));
    land.kept_clear = scene::kept_clear_of(to_edge_m);
    for (float x_m = -4; x_m <= 15; x_m += 0.37F) {
        const float read_m = scene::to_road_m(land, {x_m, 16.5F - x_m});
        EXPECT_LE(read_m, away_m(x_m) + 1e-3F) << x_m;
        EXPECT_GE(read_m, away_m(x_m) - 0.126F) << x_m;
    }
    EXPECT_LT(scene::to_road_m(land, {-16, 0}), -7.8F) << "deep within it";
    EXPECT_LE(scene::to_road_m(land, {100, 100}), scene::kFarFromRoads_m) << "outside, as at the edge";
}

TEST(Colour, OfNoNumberIsABlackByte) { EXPECT_EQ(scene::srgb_byte(std::nanf("")), 0); }

TEST(Colour, MixesBetweenItsEnds) {
    const glm::vec3 a{0.1F, 0.4F, 0.05F};
    const glm::vec3 b{0.8F, 0.3F, 0.2F};
    EXPECT_LT(glm::distance(scene::mix_colours(a, b, 0), a), 1e-5F);
    EXPECT_LT(glm::distance(scene::mix_colours(a, b, 1), b), 1e-5F);
}

TEST(Realise, HandsTheDefaultsOverAsTheyAre) {
    const scene::SceneParameters from_genes = scene::realise(genome::ParameterValues{});
    const scene::SceneParameters plain;
    EXPECT_EQ(from_genes.trees.tree_type, plain.trees.tree_type);
    EXPECT_FLOAT_EQ(from_genes.trees.tree_branch_angle_deg, 41.25F);
    EXPECT_FLOAT_EQ(from_genes.trees.tree_leaf_length_m, plain.trees.tree_leaf_length_m);
    EXPECT_FLOAT_EQ(from_genes.land.land_relief_m, plain.land.land_relief_m);
    EXPECT_FLOAT_EQ(from_genes.sky.haze_distance_m, plain.sky.haze_distance_m);
}

}  // namespace
