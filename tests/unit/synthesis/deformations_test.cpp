// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/deformations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/land/erosion.hpp"
#include "synthesis/land/field_methods.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using land::Bent;
using land::Deformation;
using land::DeformationSearch;

mesh::Field hills(std::uint64_t seed) {
    land::FieldRequest r;
    r.size = 257;
    r.seed = base::Seed{seed};
    return land::make_field(*land::field_method("fbm"), r);
}

// A ring of high ground about a low middle.
mesh::Field ring() {
    mesh::Field mask(65, 65);
    for (int y = 0; y < 65; ++y)
        for (int x = 0; x < 65; ++x) {
            const float r = std::hypot(static_cast<float>(x - 32), static_cast<float>(y - 32)) / 32;
            mask.at(x, y) = std::exp(-18 * (r - 0.6F) * (r - 0.6F)) - 0.4F;
        }
    return mask;
}

TEST(BendToMask, MeetsTheMaskWithinTheCostThatIsAskedFor) {
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
        mesh::Field land = hills(seed);
        const Bent bent = land::bend_to_mask(land, ring(), {.wished_cost = 0.05F}, base::Seed{seed});
        EXPECT_GT(bent.cost_before, 0.3) << seed;
        EXPECT_LE(bent.cost, 0.05) << seed << ": " << bent.deformations.size();
        EXPECT_LT(bent.deformations.size(), 400U);
        EXPECT_GE(bent.tried, static_cast<int>(bent.deformations.size()));
    }
}

TEST(BendToMask, CostsLessWithEachDeformationThatItMayMake) {
    double before = 1.0e9;
    for (const int most : {0, 5, 20, 80}) {
        mesh::Field land = hills(7);
        const Bent bent = land::bend_to_mask(land, ring(), {.wished_cost = 0, .most = most}, base::Seed{7});
        EXPECT_LE(bent.deformations.size(), static_cast<std::size_t>(most));
        EXPECT_LT(bent.cost, before) << most;
        before = bent.cost;
    }
}

TEST(BendToMask, FindsTheSameAgainAndDoesWhatItTells) {
    mesh::Field a = hills(2);
    mesh::Field b = a;
    mesh::Field c = a;
    const Bent first = land::bend_to_mask(a, ring(), {.most = 40}, base::Seed{5});
    land::bend_to_mask(b, ring(), {.most = 40}, base::Seed{5});
    land::deform(c, first.deformations);
    EXPECT_EQ(a, b);
    EXPECT_EQ(a, c);
    mesh::Field other = hills(2);
    land::bend_to_mask(other, ring(), {.most = 40}, base::Seed{6});
    EXPECT_NE(a, other);
}

// What makes it another method than following the mask all over: the land's own fine relief stays where it is raised.
TEST(BendToMask, LeavesALandThatFitsAsItIs) {
    mesh::Field land = hills(3);
    const mesh::Field before = land;
    mesh::Field mask = land;
    const Bent bent = land::bend_to_mask(land, mask, {}, base::Seed{1});
    EXPECT_TRUE(bent.deformations.empty());
    EXPECT_EQ(land, before);
    EXPECT_EQ(bent.moved, 0);
}

TEST(Deformations, RaiseKeepsWhatIsFinerAndLevelPressesItFlat) {
    const mesh::Field plain = hills(4);
    const auto roughness = [](mesh::Field f) {
        mesh::Field mean = f;
        land::smooth(mean, 2);
        double sum = 0;
        for (int y = 120; y < 137; ++y)
            for (int x = 120; x < 137; ++x) sum += std::abs(static_cast<double>(f.at(x, y) - mean.at(x, y)));
        return sum;
    };
    mesh::Field raised = plain;
    land::deform(raised, {{Deformation::Kind::Raise, 128, 128, 90, 0.7F}});
    EXPECT_NEAR(raised.at(128, 128), plain.at(128, 128) + 0.7F, 1.0e-5F);
    EXPECT_NEAR(roughness(raised), roughness(plain), 0.04 * roughness(plain));
    mesh::Field level = plain;
    land::deform(level, {{Deformation::Kind::Level, 128, 128, 90, 0.7F}});
    EXPECT_NEAR(level.at(128, 128), 0.7F, 1.0e-5F);
    EXPECT_LT(roughness(level), 0.2 * roughness(plain));
    EXPECT_EQ(level.at(0, 0), plain.at(0, 0)) << "beyond its reach nothing moves";
}

}  // namespace
