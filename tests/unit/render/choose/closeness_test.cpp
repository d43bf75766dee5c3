// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "render/choose/crowd.hpp"
#include "unit/render/choose/plant_kinds.hpp"

namespace quadrat::render::choose {
namespace {

TEST(Closeness, NeverGrowsCoarserAsAPlantGrowsLargerOnTheScreen) {
    for (const float fineness : {0.1F, 1.0F, 4.0F}) {
        Closeness before = closeness(tree(), 1, fineness);
        for (float px = 1; px < 1500; px *= 1.03F) {
            const Closeness now = closeness(tree(), px, fineness);
            EXPECT_LE(now.wood_level, before.wood_level) << px;
            EXPECT_GE(now.share, before.share) << px;
            before = now;
        }
        EXPECT_EQ(before.wood_level, 0U);
        EXPECT_EQ(before.share, 1.0F);
    }
}

TEST(Closeness, MoreFinenessNeverTakesAnythingAway) {
    for (float px = 2; px < 800; px *= 1.3F) {
        for (float fineness = 0.05F; fineness < 4; fineness *= 1.5F) {
            const Closeness coarse = closeness(tree(), px, fineness);
            const Closeness fine = closeness(tree(), px, fineness * 1.5F);
            EXPECT_LE(fine.wood_level, coarse.wood_level);
            EXPECT_GE(fine.share, coarse.share);
        }
    }
}

TEST(Closeness, WoodHasBecomeTheNextLevelWhenThatTakesItsPlace) {
    PlantKind bare = tree();
    bare.blades = 0;
    for (const float fineness : {0.2F, 1.0F, 3.0F}) {
        Closeness before = closeness(bare, 1500, fineness);
        int changes = 0;
        for (float px = 1500; px > 3; px *= 0.9995F) {
            const Closeness now = closeness(bare, px, fineness);
            if (now.wood_level != before.wood_level) {
                EXPECT_EQ(now.wood_level, before.wood_level + 1);
                EXPECT_GT(before.to_coarser, 0.98F) << px;
                EXPECT_LT(now.to_coarser, 0.02F) << px;
                ++changes;
            } else {
                EXPECT_NEAR(now.to_coarser, before.to_coarser, 0.02F) << px;
                EXPECT_GE(now.to_coarser, before.to_coarser) << px;
            }
            before = now;
        }
        EXPECT_EQ(changes, 4);
    }
}

TEST(Closeness, NoLimbIsMissedThatIsThickOnTheScreen) {
    PlantKind bare = tree();
    bare.blades = 0;
    for (float px = 2; px < 1500; px *= 1.1F) {
        const Closeness how = closeness(bare, px, 1);
        EXPECT_LE(bare.wood_left_out_m[how.wood_level] * px / bare.height_m, 1.31F) << px;
    }
}

TEST(Closeness, ATreeTenTimesAsLargeAsFarAwayIsDrawnAsClosely) {
    PlantKind large = tree();
    large.height_m *= 10;
    large.radius_m *= 10;
    large.blade_m *= 10;
    large.trunk_m *= 10;
    for (float& left_out_m : large.wood_left_out_m) left_out_m *= 10;
    for (float px = 2; px < 1500; px *= 1.03F) {
        const Closeness small = closeness(tree(), px, 0.5F);
        const Closeness ten_times = closeness(large, px, 0.5F);
        EXPECT_EQ(ten_times.wood_level, small.wood_level) << px;
        EXPECT_NEAR(ten_times.to_coarser, small.to_coarser, 1e-3F) << px;
        EXPECT_FLOAT_EQ(ten_times.share, small.share) << px;
    }
}

TEST(Closeness, AMassHasBecomeTheNextLevelWhenThatTakesItsPlace) {
    const std::size_t levels = leafy().mass_triangles.size();
    ASSERT_GE(levels, 2U);
    for (const float fineness : {0.01F, 1.0F, 2.0F}) {
        Closeness before = closeness(leafy(), 400, fineness);
        int changes = 0;
        for (float px = 400; px > 2; px *= 0.9995F) {
            const Closeness now = closeness(leafy(), px, fineness);
            if (before.mass_level < levels && now.mass_level != before.mass_level) {
                EXPECT_EQ(now.mass_level, before.mass_level + 1);
                EXPECT_GT(before.mass_to_coarser, 0.98F) << px;
                EXPECT_LT(now.mass_to_coarser, 0.02F) << px;
                ++changes;
            } else if (before.mass_level < levels) {
                EXPECT_NEAR(now.mass_to_coarser, before.mass_to_coarser, 0.02F) << px;
            }
            before = now;
        }
        EXPECT_GE(changes, 1) << fineness;
    }
}

TEST(Closeness, ACrownBecomesOneMassGraduallyAndNearbyNever) {
    for (const float fineness : {0.1F, 0.5F, 1.0F}) {
        Closeness before = closeness(leafy(), 500, fineness);
        for (float px = 500; px > 2; px *= 0.999F) {
            const Closeness now = closeness(leafy(), px, fineness);
            const bool is_mass = now.mass_level < leafy().mass_triangles.size();
            const bool was_mass = before.mass_level < leafy().mass_triangles.size();
            if (px > 375) {
                EXPECT_FALSE(is_mass);
            }
            if (px < 20 && fineness < 0.6F) {
                EXPECT_TRUE(is_mass);
            }
            if (is_mass && !was_mass) {
                EXPECT_LT(now.merged, 0.05F) << px;
            }
            if (is_mass && was_mass) {
                EXPECT_GE(now.merged + 1e-6F, before.merged);
            }
            before = now;
        }
    }
}

// A reed's blades are a triangle each, as a leafless crown's slivers are: that makes it none.
TEST(Closeness, ATuftIsNoLeaflessCrown) {
    PlantKind reed = grass();
    reed.blades = 300;
    reed.triangles_per_blade = 1;
    PlantKind crown = reed;
    crown.are_slivers = true;
    PlantKind folded = reed;
    folded.triangles_per_blade = 2;
    EXPECT_EQ(closeness(reed, 60, 0.05F).share, closeness(folded, 60, 0.05F).share);
    EXPECT_GT(closeness(crown, 60, 0.05F).share, 5 * closeness(reed, 60, 0.05F).share);
}

constexpr float kLookedAt_px = 200;  // crowns that are larger are leaves

// One mass so near is a hedgehog on a pole.
TEST(Closeness, ACrownThatIsLookedAtIsLeavesOnLimbsWhateverIsDrawnOfAllOthers) {
    for (const float fineness : {0.0F, 0.003F, 0.02F, 0.1F}) {
        const Closeness how = closeness(leafy(), 620, fineness);
        EXPECT_TRUE(how.has_leaves);
        EXPECT_EQ(how.merged, 0);
        EXPECT_EQ(how.mass_level, leafy().mass_triangles.size());
        EXPECT_GE(how.share, 0.39F);
        EXPECT_FALSE(how.is_plain);
        EXPECT_LE(how.wood_level, 2U);
    }
}

TEST(Closeness, ACrownOfAHandfulOfBladesIsOneMassUntilItIsLookedAt) {
    constexpr float kHandful = 12;
    for (const float fineness : {0.0001F, 0.001F, 0.005F}) {
        for (float px = 30; px < kLookedAt_px; px *= 1.1F) {
            const Closeness how = closeness(leafy(), px, fineness);
            if (fineness * 0.16F * px * px > kHandful) continue;
            ASSERT_LT(how.mass_level, leafy().mass_triangles.size()) << px;
            EXPECT_FALSE(how.has_leaves) << px;
            // And round enough for its size.
            if (px > 120) {
                EXPECT_GE(leafy().mass_triangles[how.mass_level], 28U) << px;
            }
        }
    }
}

// No crown is a bare stem with a few leaves, however large it is on the screen and however little is drawn of it.
TEST(Closeness, ACrownWhoseBladesCoverLittleHasItsMassBehindThem) {
    for (const float largest : {1.0F, 1.8F})
        for (const float fineness : {0.0001F, 0.001F, 0.01F, 0.1F, 1.0F})
            for (float px = 20; px < 1200; px *= 1.02F) {
                PlantKind kind = leafy();
                kind.largest_blade = largest;
                const Closeness how = closeness(kind, px, fineness);
                const float covered = how.has_leaves ? how.share * how.enlarged * how.enlarged : 0;
                ASSERT_GE(covered + how.merged, 0.59F) << px << " at " << fineness;
            }
}

// Its coarsest stem stands upright, and a crown may lean.
TEST(Closeness, ACrownNearByHasItsLimbsBeforeItsMass) {
    for (float px = 400; px < 1000; px *= 1.1F) EXPECT_LE(closeness(leafy(), px, 0.0005F).wood_level, 2U) << px;
    EXPECT_EQ(closeness(leafy(), 200, 0.0005F).wood_level, leafy().wood_triangles.size() - 1);
}

// Four fronds of 23 on a stem are a stake.
TEST(Closeness, AFarPalmKeepsNearlyHalfOfItsFrondsAndTheyAreLarger) {
    PlantKind palm{7, 2, {140, 60, 28, 8}, {0, 0.05F, 0.1F, 0.22F}, 23, 12, 4, 2.2F};
    palm.largest_blade = 1;
    PlantKind fern = palm;  // without a stem it is undergrowth, and thins as that does
    fern.wood_triangles = {0};
    fern.wood_left_out_m = {0};
    for (const float fineness : {0.001F, 0.02F, 0.1F})
        for (float px = 8; px < 60; px *= 1.1F) {
            const Closeness how = closeness(palm, px, fineness);
            EXPECT_TRUE(how.has_leaves);
            EXPECT_GE(how.share, 0.44F);
            EXPECT_NEAR(how.enlarged * how.enlarged * how.share, 1, 0.02F);
            EXPECT_LE(closeness(fern, px, fineness).enlarged, 1);
        }
    EXPECT_LT(closeness(fern, 20, 0.001F).share, 0.25F);
    EXPECT_EQ(closeness(palm, 300, 0.1F).enlarged, 1);
}

// Its mass stands for few of its leaves.
PlantKind airy(std::size_t coarsest) {
    PlantKind kind = leafy();
    kind.mass_triangles.back() = coarsest;
    kind.massed = 0.2F;
    return kind;
}

TEST(Closeness, ASmallCrownIsItsMassOrItsBladesWhereLittleIsDrawn) {
    const std::size_t levels = leafy().mass_triangles.size();
    for (float px = 3; px < 9; px += 0.5F) {
        const Closeness dear = closeness(airy(40), px, 0.001F);
        EXPECT_EQ(dear.mass_level, levels) << px;
        EXPECT_TRUE(dear.has_leaves) << px;
        const Closeness cheap = closeness(airy(12), px, 0.001F);
        EXPECT_LT(cheap.mass_level, levels) << px;
        EXPECT_FALSE(cheap.has_leaves) << px;
        const Closeness standard = closeness(airy(40), px, 1);
        EXPECT_LT(standard.mass_level, levels) << px;
        EXPECT_TRUE(standard.has_leaves) << px;
    }
}

TEST(Closeness, AMassThatIsLeftOutHasDwindledBefore) {
    for (const float fineness : {0.0001F, 0.01F, 0.05F}) {
        float before = 1;
        for (float px = 60; px > 2; px *= 0.999F) {
            const Closeness how = closeness(airy(40), px, fineness);
            const float size = how.mass_level < airy(40).mass_triangles.size() ? how.mass_size : 0;
            EXPECT_NEAR(size, before, 0.02F) << px;
            before = size;
        }
    }
}

TEST(Closeness, NoBladeThatStandsForManyIsLongOnTheScreen) {
    constexpr float kLong_px = 16;
    constexpr float kMany = 4.5F * 4.5F;
    for (const float massed : {0.2F, 0.8F}) {
        PlantKind kind = leafy();
        kind.massed = massed;
        for (const float largest : {1.5F, 6.0F, 100.0F}) {
            kind.largest_blade = largest;
            for (const float fineness : {0.0F, 0.003F, 0.02F, 0.1F, 0.4F}) {
                for (float px = 14; px < kLookedAt_px; px *= 1.03F) {
                    const Closeness how = closeness(kind, px, fineness);
                    const float blade_px = kind.blade_m / kind.height_m * px * how.enlarged;
                    const bool stands_for_many = 0.22F * fineness * px * px * kMany < static_cast<float>(kind.blades);
                    EXPECT_FALSE(how.has_leaves && stands_for_many && blade_px > kLong_px)
                        << px << " " << fineness << " " << largest;
                    EXPECT_LE(how.enlarged, largest);
                }
            }
        }
    }
}

TEST(Closeness, ACrownThatIsNeverAMassKeepsBladesNearBy) {
    for (const float fineness : {0.0F, 0.001F, 0.01F}) {
        const auto blades = [&](float px) {
            return closeness(tree(), px, fineness).share * static_cast<float>(tree().blades);
        };
        EXPECT_GE(blades(400), 200) << fineness;
        EXPECT_GE(blades(100), 12) << fineness;
        EXPECT_LE(blades(20), 8) << fineness;
    }
}

TEST(Closeness, APlantNearByStandsForItselfAlone) {
    for (const float fineness : {0.0F, 0.0001F, 0.01F, 1.0F})
        for (float px = 45; px < 1000; px *= 1.1F) EXPECT_EQ(closeness(leafy(), px, fineness).stand, 1) << px;
    EXPECT_LT(closeness(tree(), 10, 0).stand, 0.5F);
}

TEST(Closeness, ACrownThatIsOneMassStandsForItselfUntilItIsASpeck) {
    for (const float fineness : {0.0F, 0.01F, 0.1F})
        for (float px = 22; px < 100; px *= 1.1F) EXPECT_EQ(closeness(leafy(), px, fineness).stand, 1) << px;
    EXPECT_LT(closeness(leafy(), 8, 0).stand, 0.5F);
}

TEST(Closeness, ASubjectKeepsItsLeavesAndLimbs) {
    const std::size_t no_mass = leafy().mass_triangles.size();
    for (const float px : {70.0F, 120.0F, 250.0F}) {
        const Closeness crowded = closeness(leafy(), px, 0.01F);
        const Closeness subject = closeness(leafy(), px, 0.01F, 1);
        EXPECT_LT(crowded.mass_level, no_mass) << px;
        EXPECT_EQ(subject.mass_level, no_mass) << px;
        EXPECT_GE(subject.share, 0.69F) << px;
        EXPECT_LE(subject.wood_level, crowded.wood_level) << px;
    }
}

}  // namespace
}  // namespace quadrat::render::choose
