// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/layered_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "synthesis/land/overhangs.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using land::LayeredGround;
using land::Material;

TEST(LayeredGround, HoldsWhatWasFilledInLast) {
    LayeredGround ground(3, 2, 1, -2);
    ground.fill(1, 1, -5, 4, Material::Rock);
    ground.fill(1, 1, 1, 2, Material::Air);
    ground.fill(1, 1, 1, 1.5F, Material::Sand);
    EXPECT_EQ(ground.at(1, 1, -1), Material::Rock);
    EXPECT_EQ(ground.at(1, 1, 1.2F), Material::Sand);
    EXPECT_EQ(ground.at(1, 1, 1.7F), Material::Air);
    EXPECT_EQ(ground.at(1, 1, 3), Material::Rock);
    EXPECT_EQ(ground.at(1, 1, 4.1F), Material::Air);
    EXPECT_EQ(ground.at(0, 0, 0), Material::Air);
    EXPECT_EQ(ground.at(0, 0, -3), Material::Rock) << "under the bottom";
    EXPECT_FLOAT_EQ(ground.floor_m(1, 1, 1.8F), 1.5F);
    EXPECT_FLOAT_EQ(ground.ceiling_m(1, 1, 1.5F), 2);
    EXPECT_GT(ground.ceiling_m(1, 1, 4), 1.0e5F);
    EXPECT_NEAR(ground.volume_m3(Material::Rock), 5, 1.0e-6);
    EXPECT_NEAR(ground.volume_m3(Material::Sand), 0.5, 1.0e-6);
    EXPECT_EQ(ground.column(1, 1).size(), 4U);
}

TEST(LayeredGround, LosesNoSandAndLeavesNoneSteeperThanItCanBe) {
    LayeredGround ground(15, 15, 1, 0);
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 15; ++x) ground.fill(x, y, 0, 1, Material::Rock);
    ground.fill(7, 7, 1, 13, Material::Sand);
    ground.fill(3, 3, 6, 8, Material::Sand);  // in the air: it falls
    ground.fill(9, 7, 3, 4, Material::Rock);  // a roof, under which sand may run
    const double before = ground.volume_m3(Material::Sand);
    ground.settle(0.7F, 300);
    EXPECT_NEAR(ground.volume_m3(Material::Sand), before, 1.0e-3);
    EXPECT_NE(ground.at(3, 3, 7), Material::Sand);
    EXPECT_EQ(ground.at(9, 7, 3.5F), Material::Rock) << "rock stays where it is";
    EXPECT_EQ(ground.at(9, 7, 1.3F), Material::Sand) << "sand has run under the roof";
    for (int y = 1; y < 14; ++y) {
        for (int x = 1; x < 14; ++x) {
            const float top_m = ground.floor_m(x, y, 2.9F);
            if (ground.at(x, y, top_m - 0.01F) != Material::Sand) continue;
            for (const int side : {-1, 1}) {
                EXPECT_LT(top_m - ground.floor_m(x + side, y, 2.9F), 0.7F + 0.05F);
                EXPECT_LT(top_m - ground.floor_m(x, y + side, 2.9F), 0.7F + 0.05F);
            }
        }
    }
}

TEST(LayeredGround, RockThatHangsOnNothingFalls) {
    LayeredGround ground(8, 4, 1, 0);
    for (int x = 0; x < 8; ++x) ground.fill(x, 1, 0, 1, Material::Rock);
    ground.fill(1, 1, 1, 5, Material::Rock);
    for (int x = 1; x < 4; ++x) ground.fill(x, 1, 4, 5, Material::Rock);  // an arm that hangs on the pillar
    ground.fill(6, 1, 4, 5, Material::Rock);                              // and what hangs on nothing
    EXPECT_NEAR(ground.drop_loose_rock_m3(0.25F), 1, 1.0e-4);
    EXPECT_EQ(ground.at(3, 1, 4.5F), Material::Rock);
    EXPECT_EQ(ground.at(6, 1, 4.5F), Material::Sand);
    ground.settle(0.7F, 1);
    EXPECT_EQ(ground.at(6, 1, 4.5F), Material::Air);
    EXPECT_NEAR(ground.drop_loose_rock_m3(0.25F), 0, 1.0e-6);
}

TEST(LayeredGround, ItsSurfaceIsClosedAndLiesWhereTheGroundIs) {
    const LayeredGround fin = land::weathered_fin({}, base::Seed{3});
    const mesh::Surface surface = fin.surface();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < surface.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{surface.indices[i + k], surface.indices[i + (k + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        ASSERT_TRUE(back != edges.end() && back->second == count);
    }
    EXPECT_LT(surface.indices.size() / 3, 9000U);
    float top_m = 0;
    for (const glm::vec3& at : surface.positions) top_m = std::max(top_m, at.y);
    EXPECT_NEAR(top_m, 14, 3);
}

// Caves, alcoves, arches: a grown person has room under the rock.
TEST(WeatheredFin, OneCanStandUnderItAndNoneOfItHangsOnNothing) {
    int windows = 0;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        LayeredGround fin = land::weathered_fin({.recess = 0.9F}, base::Seed{seed});
        int roofed = 0;
        for (int y = 0; y < fin.rows(); ++y) {
            for (int x = 0; x < fin.columns(); ++x) {
                const float floor_m = fin.floor_m(x, y, 0.3F);
                const float ceiling_m = fin.ceiling_m(x, y, floor_m + 0.05F);
                roofed += ceiling_m < 1.0e5F && ceiling_m - floor_m > 1.9F;
            }
        }
        EXPECT_GT(roofed, 8) << seed;
        EXPECT_NEAR(fin.drop_loose_rock_m3(0.5F * 14 / 40), 0, 0.5) << seed;
        // Through and through, somewhere: a row of columns with no rock at breast height between two that have it.
        for (int x = 8; x < 28; ++x) {
            bool is_open = true;
            bool has_roof = false;
            for (int y = 0; y < fin.rows(); ++y) {
                const float breast_m = std::max(fin.floor_m(x, y, 0.3F), 0.0F) + 1.4F;
                is_open = is_open && fin.at(x, y, breast_m) == Material::Air;
                has_roof = has_roof || fin.ceiling_m(x, y, breast_m) < 1.0e5F;
            }
            windows += is_open && has_roof;
        }
    }
    EXPECT_GT(windows, 3) << "arches, in some of the sixteen";
}

TEST(WeatheredFin, SoftBedsGoBackAsFarAsTheyAreAsked) {
    double before = 1.0e9;
    for (const float recess : {0.3F, 0.7F, 1.2F}) {
        const double rock = land::weathered_fin({.recess = recess}, base::Seed{5}).volume_m3(Material::Rock);
        EXPECT_LT(rock, before);
        before = rock;
    }
    EXPECT_LT(land::weathered_fin({.sand = 0}, base::Seed{5}).volume_m3(Material::Sand),
              0.3 * land::weathered_fin({.sand = 1}, base::Seed{5}).volume_m3(Material::Sand));
}

}  // namespace
