// SPDX-License-Identifier: Apache-2.0
// Baked light where what it must be is known: a ridge, a tree, a valley, a red flank, a tree behind a tree.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "synthesis/compose/crown_shadows.hpp"
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/openness.hpp"

namespace quadrat::synthesis {
namespace {

const glm::vec3 kFromTheEast = glm::normalize(glm::vec3{1, 1, 0});  // 45 degrees high

// Land that is the same all the way from north to south.
scene::Land profiled(int samples, float cell_m, const std::function<float(float east_m)>& height_m) {
    scene::Land land;
    land.cell_m = cell_m;
    land.height_m = mesh::Field(samples, samples);
    for (int row = 0; row < samples; ++row)
        for (int column = 0; column < samples; ++column)
            land.height_m.at(column, row) = height_m(cell_m * static_cast<float>(column - samples / 2));
    return land;
}

// Its leaves have so many times the crown's area, seen from above.
scene::Flora of_one_species(float height_m, float crown_radius_m, float leaves_to_crown = 4) {
    scene::Flora flora;
    flora.species.emplace_back();
    scene::Species& species = flora.species[0];
    species.height_m = height_m;
    species.crown_radius_m = crown_radius_m;
    constexpr std::uint32_t kLeaves = 100;
    const float leaf_m2 = leaves_to_crown * 3.1416F * crown_radius_m * crown_radius_m / kLeaves;
    for (std::uint32_t i = 0; i < 3 * kLeaves; ++i) {
        scene::Leaves::Vertex corner{};
        if (i % 3 != 0) corner.corner_m[static_cast<int>(i % 3) - 1] = std::sqrt(2 * leaf_m2);
        species.leaves.vertices.push_back(corner);
        species.leaves.indices.push_back(i);
    }
    return flora;
}

scene::Plant standing_at(const glm::vec3& root_m) {
    scene::Plant plant;
    plant.root_m = root_m;
    return plant;
}

// Of a ridge in the middle of level land: how far west of it so much of the sun is seen.
float west_of_ridge_m(const LandShadow& shadow, float sun) {
    constexpr float kStep_m = 0.05F;
    float west_m = 1;  // the ridge's own side is lit
    while (west_m < 100 && shadow.sun_at({-west_m, 0, 0}) <= sun) west_m += kStep_m;
    return west_m;
}

TEST(LandShadow, OfARidgeIsAsLongAsItIsHighUnderASunAt45DegreesAndSofterFarther) {
    float softness_before_m = 0;
    for (const float high_m : {10.0F, 20.0F, 40.0F}) {
        const scene::Land land = profiled(257, 1, [&](float east_m) { return east_m == 0 ? high_m : 0; });
        const LandShadow shadow(land, kFromTheEast);
        EXPECT_EQ(shadow.sun_at({20, 0, 0}), 1) << "before it";
        EXPECT_EQ(shadow.sun_at({-0.7F * high_m, 0, 0}), 0) << "behind it";
        EXPECT_NEAR(west_of_ridge_m(shadow, 0.5F), high_m, 0.1F);
        const float softness_m = west_of_ridge_m(shadow, 0.9F) - west_of_ridge_m(shadow, 0.1F);
        EXPECT_GT(softness_m, 1.2F * softness_before_m) << high_m;
        softness_before_m = softness_m;
    }
}

// The shadow of an ellipsoid by parallel light on level ground is an ellipse; the stem's lies between it and the root.
TEST(CrownShadow, OfATreeIsAnEllipseWhereItsCrownIsCastTo) {
    constexpr float kHigh_m = 20;
    constexpr float kRadius_m = 5;
    constexpr int kSide = 256;  // pixels, half a metre each
    const scene::Land land = profiled(129, 1, [](float) { return 0; });
    const scene::Plant tree = standing_at({0, 0, 0});
    const CrownShade shade = cast_crowns(land, kFromTheEast, of_one_species(kHigh_m, kRadius_m), {&tree, 1}, kSide);
    const float west_m = 0.58F * kHigh_m;  // as far as the crown's middle is high
    const float along_m = std::hypot(kRadius_m, 0.4F * kHigh_m);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const glm::vec2 at{0.5F * (static_cast<float>(x) + 0.5F) - 64, 0.5F * (static_cast<float>(y) + 0.5F) - 64};
            const float r = std::hypot((at.x + west_m) / along_m, at.y / kRadius_m);
            if (r < 0.95F) {
                EXPECT_LT(shade.sun.at(x, y), 0.9F) << at.x << ' ' << at.y;
            } else if (r > 1.05F && at.x < -west_m) {
                EXPECT_EQ(shade.sun.at(x, y), 1) << at.x << ' ' << at.y;
            }
        }
    }
}

TEST(CrownShadow, OfABareTreeIsFainterThanOfOneInLeaf) {
    const scene::Land land = profiled(129, 1, [](float) { return 0; });
    const scene::Plant tree = standing_at({0, 0, 0});
    const auto shade_of = [&](float leaves_to_crown) {
        return cast_crowns(land, kFromTheEast, of_one_species(20, 5, leaves_to_crown), {&tree, 1}, 256);
    };
    const CrownShade leafy = shade_of(4);
    const CrownShade bare = shade_of(0);
    constexpr int kRoot = 128;
    constexpr int kShadow = kRoot - 24;
    EXPECT_LT(leafy.sky.at(kRoot, kRoot), 0.6F);
    EXPECT_GT(bare.sky.at(kRoot, kRoot), 0.85F);
    EXPECT_LT(bare.sun.at(kShadow, kRoot), 0.7F) << "its limbs cast one";
    EXPECT_LT(leafy.sun.at(kShadow, kRoot), 0.5F * bare.sun.at(kShadow, kRoot));
}

// From its bottom the horizon of a valley stands at atan |sin a|, a from the valley's own direction: of the sky,
// weighted by its height, 1 / sqrt 2 is seen, the mean of 1 / (1 + sin^2 a). Eight directions over whole samples err by
// less than 0.05.
TEST(SkyOpenness, OfAnEndlessValleyWithFlanksOf45DegreesIsKnown) {
    constexpr int kMiddle = 32;  // the only samples there are lie at odd columns
    const scene::Land valley = profiled(129, 2, [](float east_m) { return std::abs(east_m - 2); });
    EXPECT_NEAR(sky_openness(valley).at(kMiddle, kMiddle), std::sqrt(0.5F), 0.05F);
    EXPECT_EQ(sky_openness(profiled(129, 2, [](float) { return 7; })).at(kMiddle, kMiddle), 1);
}

TEST(BakedLight, OfARedFlankFillsTheFootOfTheOppositeOne) {
    constexpr int kSide = 256;  // pixels, 4 m each
    scene::Land valley = profiled(513, 2, [](float east_m) { return 5 + std::abs(east_m); });
    mesh::Image albedo(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) albedo.pixel(x, y)[c] = x >= 32 ? (c == 0 ? 220 : 20) : 120;
    valley.albedo = scene::GroundColours(albedo);
    scene::Sky sky;  // without any light of its own: what is not lit by the sun is lit by the flanks
    sky.sun_direction = glm::normalize(glm::vec3{-1, 1, 0});
    const LandShadow shadow(valley, sky.sun_direction);
    const scene::BakedLight light = bake_light(valley, openness_of(valley), sky, {}, {}, shadow, kSide);
    const auto at = [&](int east_px) { return light.ground.pixel(kSide / 2 + east_px, kSide / 2); };
    EXPECT_GT(at(20)[0], 100) << "the flank that faces the sun";
    const auto* foot = at(-2);
    EXPECT_GE(foot[0], 5);
    EXPECT_GT(foot[0], 3 * foot[1]) << "red";
    EXPECT_LT(at(-60)[0], foot[0] / 2) << "high above it";
}

// Waves of 32 m, under a sky that is alike everywhere.
TEST(BakedLight, UnderAnEvenSkyShowsRidgesAndGullies) {
    scene::Land waves = profiled(129, 1, [](float east_m) { return 20 + 3 * std::cos(0.19635F * east_m); });
    waves.far_colour = glm::vec3{0};  // nothing is thrown back
    scene::Sky sky;
    constexpr int kPieces = 400;
    for (int i = 0; i < kPieces; ++i) {
        const float y = (static_cast<float>(i) + 0.5F) / kPieces;
        const float turn = 2.3999632F * static_cast<float>(i);
        const float flat = std::sqrt(1 - y * y);
        sky.ambient.add({flat * std::cos(turn), y, flat * std::sin(turn)}, glm::vec3{0.5F}, 6.2832F / kPieces);
    }
    const LandShadow shadow(waves, sky.sun_direction);
    const auto light = bake_light(waves, openness_of(waves), sky, {}, {}, shadow, 128);
    const auto at = [&](int east_m) { return static_cast<int>(light.ground.pixel(64 + east_m, 64)[1]); };
    EXPECT_GT(at(0), at(16) + 18) << "a ridge and a gully";
    EXPECT_NEAR(at(0), at(32), 3) << "each ridge like the next";
}

TEST(PlantLight, OfATreeBehindATreeIsLess) {
    constexpr float kApart_m = 8;
    const scene::Flora flora = of_one_species(10, 3);
    const scene::Land land = profiled(129, 1, [](float) { return 0; });
    scene::Sky sky;
    sky.sun_direction = glm::normalize(glm::vec3{1, 0.2F, 0});
    std::vector<scene::Plant> plants{standing_at({0, 0, 0}), standing_at({-kApart_m, 0, 0}),
                                     standing_at({-kApart_m, 0, 2 * kApart_m})};
    light_plants(plants, flora, sky, LandShadow(land, sky.sun_direction));
    EXPECT_EQ(plants[0].sun, 1) << "before it";
    EXPECT_LT(plants[1].sun, 0.7F);
    EXPECT_GT(plants[1].sun, 0.2F) << "leaves let some through";
    EXPECT_EQ(plants[2].sun, 1) << "beside it";
}

}  // namespace
}  // namespace quadrat::synthesis
