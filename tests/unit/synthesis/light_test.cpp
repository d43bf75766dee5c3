// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/openness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/compose/stone_shadows.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kHigh_m = 5;    // of the level ground
constexpr float kBlock_m = 16;  // a side and the height of the block of stone
constexpr int kSide = 64;       // pixels, 2 m each

// Level ground with a block of stone in its middle.
scene::Land plain_with_block() {
    scene::Land land;
    land.height_m = mesh::Field(65, 65, kHigh_m);
    land.cell_m = 2;
    for (int i = 0; i < 8; ++i)
        land.stone.mesh.positions_m.push_back({((i & 1) != 0 ? 0.5F : -0.5F) * kBlock_m,
                                               kHigh_m + ((i & 4) != 0 ? kBlock_m : 0),
                                               ((i & 2) != 0 ? 0.5F : -0.5F) * kBlock_m});
    for (const auto& [a, b, c, d] :
         {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
        for (const int corner : {a, b, c, a, c, d})
            land.stone.mesh.indices.push_back(static_cast<std::uint32_t>(corner));
    land.stone.mesh.normals.resize(8, {0, 1, 0});
    land.stone.colours.resize(8, glm::vec3{0.5F});
    return land;
}

double shaded_m2(const mesh::Field& hidden) {
    double pixels = 0;
    for (const float share : hidden.samples) pixels += share;
    return 4 * pixels;
}

// Cast along one axis by a sun 45 degrees high, a cube's shadow is as long again as the cube.
TEST(StoneShadow, HasTheAreaOfItsProjection) {
    const scene::Land land = plain_with_block();
    EXPECT_NEAR(shaded_m2(cast_stone(land, {0, 1, 0}, kSide)), kBlock_m * kBlock_m, 8);
    EXPECT_NEAR(shaded_m2(cast_stone(land, glm::normalize(glm::vec3{1, 1, 0}), kSide)), 2 * kBlock_m * kBlock_m, 24);
    const float half = std::sqrt(0.5F);
    EXPECT_NEAR(shaded_m2(cast_stone(land, glm::normalize(glm::vec3{half, 1, half}), kSide)),
                kBlock_m * kBlock_m * (1 + 2 * half), 32);
}

TEST(StoneShadow, LiesAwayFromTheSun) {
    const mesh::Field hidden = cast_stone(plain_with_block(), glm::normalize(glm::vec3{1, 1, 0}), kSide);
    EXPECT_EQ(hidden.at(kSide / 2 - 8, kSide / 2), 1);  // 16 m to the west
    EXPECT_EQ(hidden.at(kSide / 2 + 8, kSide / 2), 0);
    EXPECT_EQ(hidden.at(kSide / 2, kSide / 2 - 8), 0);
}

TEST(StoneShadow, DarkensTheGroundThatIsLit) {
    scene::Land land = plain_with_block();
    scene::Sky sky;
    sky.sun_direction = glm::normalize(glm::vec3{1, 1, 0});
    const LandShadow shadow(land, sky.sun_direction);
    const scene::BakedLight with = bake_light(land, openness_of(land), sky, {}, {}, shadow, kSide);
    land.stone = {};
    const scene::BakedLight without = bake_light(land, openness_of(land), sky, {}, {}, shadow, kSide);
    const auto green = [](const scene::BakedLight& light, int x) { return light.ground.pixel(x, kSide / 2)[1]; };
    EXPECT_LT(green(with, kSide / 2 - 8), 0.7 * green(without, kSide / 2 - 8));
    EXPECT_EQ(green(with, kSide / 2 + 8), green(without, kSide / 2 + 8));
}

}  // namespace
}  // namespace quadrat::synthesis
