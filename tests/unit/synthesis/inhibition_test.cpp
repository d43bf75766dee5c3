// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/inhibition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "synthesis/trees/leaf_shape.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kLeaves = 36;

// From each leaf to the next, 0 to 180.
std::vector<float> divergences_deg(const std::vector<Primordium>& leaves) {
    std::vector<float> all;
    for (std::size_t i = 1; i < leaves.size(); ++i) {
        const float off = std::fmod(57.29578F * (leaves[i].turn_rad - leaves[i - 1].turn_rad) + 720, 360.0F);
        all.push_back(std::min(off, 360 - off));
    }
    return all;
}

// How many stand at a level, in the mean.
float a_level(const std::vector<Primordium>& leaves) {
    const float mean = (leaves.front().below - leaves.back().below) / static_cast<float>(leaves.size() - 1);
    int levels = 1;
    for (std::size_t i = 1; i < leaves.size(); ++i) levels += leaves[i - 1].below - leaves[i].below > 0.2F * mean;
    return static_cast<float>(leaves.size()) / static_cast<float>(levels);
}

enum class Mode { TwoRows, Spiral, Pairs, Whorls, Other };
Mode mode_of(float gamma) {
    const auto leaves = leaves_of_shoot(gamma, kLeaves);
    const auto off = divergences_deg(leaves);
    const float level = a_level(leaves);
    const auto [least, most] = std::ranges::minmax(off);
    if (level < 1.1F && least > 174) return Mode::TwoRows;
    if (level < 1.1F && least > 122 && most < 160) return Mode::Spiral;
    if (std::abs(level - 2) < 0.12F) return Mode::Pairs;
    if (level > 3.4F) return Mode::Whorls;
    return Mode::Other;
}

TEST(Inhibition, GivesTheModesInTheirKnownOrder) {
    std::vector<Mode> order;
    for (float gamma = kMostInhibition; gamma >= kLeastInhibition; gamma -= 0.02F) {
        const Mode mode = mode_of(gamma);
        if (mode != Mode::Other && std::ranges::find(order, mode) == order.end()) order.push_back(mode);
    }
    EXPECT_EQ(order, (std::vector<Mode>{Mode::TwoRows, Mode::Spiral, Mode::Pairs, Mode::Whorls}));
}

TEST(Inhibition, OfASpiralIsTheGoldenAngle) {
    const auto off = divergences_deg(leaves_of_shoot(1.75F, kLeaves));
    float mean = 0;
    for (const float angle : off) {
        EXPECT_NEAR(angle, 137.5F, 6);
        mean += angle / static_cast<float>(off.size());
    }
    EXPECT_NEAR(mean, 137.5F, 2);
}

TEST(Inhibition, SetsPairsAcrossThePairBelow) {
    const auto leaves = leaves_of_shoot(1.34F, kLeaves);
    EXPECT_NEAR(a_level(leaves), 2, 0.12F);
    // One step within a pair, the next between two, in turns.
    const auto off = divergences_deg(leaves);
    for (std::size_t i = 2; i < off.size(); ++i) EXPECT_NEAR(off[i], off[i - 2], 4);
    EXPECT_NEAR(std::max(off[0], off[1]), 178, 6);
    EXPECT_NEAR(std::min(off[0], off[1]), 92, 8);
}

TEST(Inhibition, NeverSetsALeafWhereThoseBeforeItForbidIt) {
    for (const float gamma : {0.7F, 1.0F, 1.34F, 1.75F, 2.3F}) {
        const auto leaves = leaves_of_shoot(gamma, kLeaves);
        for (std::size_t i = 0; i < leaves.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const float up = leaves[k].below - leaves[i].below;
                const float d2 = 2 - 2 * std::cos(leaves[i].turn_rad - leaves[k].turn_rad) + up * up;
                EXPECT_GE(d2, 0.98F * gamma * gamma) << gamma << " " << i << " " << k;
            }
    }
}

TEST(Inhibition, ArrangesTheLeavesOfASprayAndKeepsTheirNumber) {
    for (const LeafKind kind : {LeafKind::Ovate, LeafKind::Round, LeafKind::Lobed, LeafKind::Heart}) {
        const LeafShape rows = spray_shape(kind, kMostInhibition);
        const LeafShape pairs = spray_shape(kind, 1.34F);
        EXPECT_EQ(rows.triangles.size(), spray_shape(kind).triangles.size());
        EXPECT_EQ(pairs.triangles.size(), rows.triangles.size());
        EXPECT_EQ(rows.lift.size(), rows.outline.size());
        const auto highest = [](const LeafShape& shape) {
            float most = 0;
            for (const float lift : shape.lift) most = std::max(most, std::abs(lift));
            return most;
        };
        EXPECT_LT(highest(rows), 0.03F) << "two rows lie in one plane";
        EXPECT_GT(highest(pairs), 0.15F) << "the second pair stands across the first";
    }
    EXPECT_TRUE(spray_shape(LeafKind::Needles, 1.0F).lift.empty());
}

}  // namespace
}  // namespace quadrat::synthesis::trees
