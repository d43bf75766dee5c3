// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/bridges.hpp"
#include "synthesis/houses/network.hpp"

namespace quadrat::synthesis::houses {
namespace {

// Rises to the north by slope; a brook of a width and a depth runs from west to east south of the middle.
scene::Land land_of(float slope, float brook_m = 0, float deep_m = 0) {
    scene::Land land;
    land.cell_m = 2;
    land.height_m = mesh::Field(513, 513);
    land.water_m = mesh::Field(513, 513, scene::kNoWater);
    for (int y = 0; y < 513; ++y)
        for (int x = 0; x < 513; ++x) {
            const float z = 2 * static_cast<float>(y - 256);
            float& h = land.height_m.at(x, y);
            h = 60 - slope * z;
            if (brook_m <= 0) continue;
            const float off = std::abs(z - 70);
            if (off > 0.5F * brook_m + 4) continue;
            h -= deep_m + 1;
            if (off < 0.5F * brook_m) land.water_m.at(x, y) = h + deep_m;
            if (off >= 0.5F * brook_m) h += deep_m + 0.6F;
        }
    return land;
}

scene::LandParameters of(Streets pattern) {
    scene::LandParameters p;
    p.settle_streets = static_cast<float>(pattern);
    p.settle_winding = 0.3F;
    EXPECT_EQ(streets_of(p), pattern);
    return p;
}

const std::array kPatterns{Streets::Raster, Streets::Radial, Streets::Organic};

float total_m(const std::vector<Branch>& branches) {
    float sum = 0;
    for (const Branch& b : branches)
        for (std::size_t i = 0; i + 1 < b.lane.line_m.size(); ++i)
            sum += glm::distance(b.lane.line_m[i], b.lane.line_m[i + 1]);
    return sum;
}

// The mean of a measure over all steps of all lanes but the first two, which are the street.
template <typename Measure>
float mean_step(const std::vector<Branch>& branches, const Measure& measure) {
    float sum = 0;
    int count = 0;
    for (std::size_t b = 2; b < branches.size(); ++b)
        for (std::size_t i = 0; i + 1 < branches[b].lane.line_m.size(); ++i, ++count)
            sum += measure(branches[b].lane.line_m[i], branches[b].lane.line_m[i + 1]);
    return sum / static_cast<float>(std::max(count, 1));
}

TEST(Streets, GrowOnLevelLandByEachPattern) {
    const scene::Land land = land_of(0);
    for (const Streets pattern : kPatterns)
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const std::vector<Branch> branches = grow_network(land, {0, 0}, of(pattern), base::Seed{seed});
            EXPECT_GT(branches.size(), 20U) << static_cast<int>(pattern) << ", " << seed;
            EXPECT_LE(branches.size(), 72U);
            EXPECT_GT(total_m(branches), 1500.0F) << static_cast<int>(pattern) << ", " << seed;
            for (const Branch& branch : branches) {
                if (branch.from < 0) continue;
                const std::vector<glm::vec2>& line = branches[static_cast<std::size_t>(branch.from)].lane.line_m;
                const auto at = static_cast<std::size_t>(std::lround(branch.from_at_m / kLaneStep_m));
                ASSERT_LT(at, line.size());
                EXPECT_LT(glm::distance(line[at], branch.lane.line_m.front()), 0.01F);
            }
        }
}

TEST(Streets, OfARasterMeetAtRightAngles) {
    const std::vector<Branch> branches = grow_network(land_of(0), {0, 0}, of(Streets::Raster), base::Seed{3});
    const glm::vec2 axis = glm::normalize(branches[0].lane.line_m[1] - branches[0].lane.line_m[0]);
    const float astray = mean_step(branches, [axis](glm::vec2 a, glm::vec2 b) {
        const glm::vec2 d = glm::normalize(b - a);
        return std::min(std::abs(axis.x * d.x + axis.y * d.y), std::abs(axis.x * d.y - axis.y * d.x));
    });
    EXPECT_LT(astray, 0.12F);
}

TEST(Streets, OfARadialTownRunRoundTheMiddleOrAwayFromIt) {
    const auto astray = [](glm::vec2 a, glm::vec2 b) {
        const glm::vec2 d = glm::normalize(b - a);
        const glm::vec2 out = glm::normalize(0.5F * (a + b));
        return std::min(std::abs(glm::dot(out, d)), std::abs(out.x * d.y - out.y * d.x));
    };
    const std::vector<Branch> radial = grow_network(land_of(0), {0, 0}, of(Streets::Radial), base::Seed{3});
    const std::vector<Branch> raster = grow_network(land_of(0), {0, 0}, of(Streets::Raster), base::Seed{3});
    EXPECT_LT(mean_step(radial, astray), 0.2F);
    EXPECT_GT(mean_step(raster, astray), 0.25F);
}

TEST(Streets, BendWithTheLandSoThatTheyClimbLittle) {
    const scene::Land land = land_of(0.2F);
    const auto climb = [&land](glm::vec2 a, glm::vec2 b) {
        return std::abs(scene::ground_height_m(land, b) - scene::ground_height_m(land, a)) / glm::distance(a, b);
    };
    for (const Streets pattern : kPatterns) {
        const std::vector<Branch> branches = grow_network(land, {0, 0}, of(pattern), base::Seed{5});
        for (const Branch& b : branches)
            for (std::size_t i = 0; i + 1 < b.lane.line_m.size(); ++i)
                EXPECT_LE(climb(b.lane.line_m[i], b.lane.line_m[i + 1]), 0.25F);
    }
    // A lane straight up would climb 0.2.
    EXPECT_LT(mean_step(grow_network(land, {0, 0}, of(Streets::Organic), base::Seed{5}), climb), 0.12F);
}

TEST(Streets, MeetEachOtherInLoops) {
    const scene::Land land = land_of(0);
    for (const Streets pattern : {Streets::Raster, Streets::Radial}) {
        const std::vector<Branch> branches = grow_network(land, {0, 0}, of(pattern), base::Seed{3});
        int meet = 0;
        for (std::size_t b = 2; b < branches.size(); ++b) {
            const glm::vec2 end = branches[b].lane.line_m.back();
            for (std::size_t c = 0; c < branches.size(); ++c) {
                const auto on = [end](glm::vec2 p) { return glm::distance(p, end) < 2.6F; };
                if (c != b && std::ranges::any_of(branches[c].lane.line_m, on)) {
                    ++meet;
                    break;
                }
            }
        }
        EXPECT_GE(meet, 4) << static_cast<int>(pattern);
    }
}

TEST(Streets, CrossABrookStraightAndNoLake) {
    const scene::Land brook = land_of(0, 8, 1.2F);
    const scene::Land lake = land_of(0, 60, 3);
    for (const Streets pattern : kPatterns) {
        std::size_t crossed = 0;
        for (const Branch& branch : grow_network(brook, {0, 20}, of(pattern), base::Seed{7})) {
            for (const Lane::Crossing& crossing : branch.lane.crossings) {
                ++crossed;
                ASSERT_LT(crossing.to, branch.lane.line_m.size());
                const glm::vec2 from = branch.lane.line_m[crossing.from];
                const glm::vec2 to = branch.lane.line_m[crossing.to];
                EXPECT_TRUE(is_buildable(brook, from) && is_buildable(brook, to));
                EXPECT_LT((from.y - 70) * (to.y - 70), 0) << "from bank to bank";
            }
            for (std::size_t i = 0; i < branch.lane.line_m.size(); ++i) {
                const bool is_crossing = std::ranges::any_of(
                    branch.lane.crossings, [i](const Lane::Crossing& c) { return i > c.from && i < c.to; });
                EXPECT_TRUE(is_crossing || scene::water_depth_m(brook, branch.lane.line_m[i]) <= 0);
            }
        }
        EXPECT_GE(crossed, 1U) << static_cast<int>(pattern);
        EXPECT_LE(crossed, 3U);
        for (const Branch& branch : grow_network(lake, {0, 20}, of(pattern), base::Seed{7}))
            EXPECT_TRUE(branch.lane.crossings.empty());
    }
}

Settled one_lane_over(const scene::Land& land) {
    Settled settled;
    Lane lane;
    for (float z = 40; z <= 100; z += kLaneStep_m) lane.line_m.emplace_back(3, z);
    lane.crossings.push_back({4, 8});
    settled.lanes.push_back(lane);
    EXPECT_GT(scene::water_depth_m(land, {3, 70}), 0);
    return settled;
}

TEST(Bridges, SpanDeepWaterAboveItAndReachBothBanks) {
    const scene::Land land = land_of(0, 8, 1.2F);
    const Settled settled = one_lane_over(land);
    const std::vector<Span> spans = spans_of(land, settled);
    ASSERT_EQ(spans.size(), 1U);
    EXPECT_NEAR(spans[0].deepest_m, 1.2F, 0.05F);
    for (const int region : {0, 4}) {
        scene::LandParameters p;
        p.settle_region = static_cast<float>(region);
        const std::vector<scene::Masses> bridges = add_bridges(land, settled, p);
        ASSERT_EQ(bridges.size(), 1U);
        float south = -1.0e9F;
        float north = 1.0e9F;
        // Where one walks: what faces up between the sides.
        float lowest_deck_m = 1.0e9F;
        const mesh::Mesh& mesh = bridges[0].mesh;
        for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
            const glm::vec3& p0 = mesh.positions_m[i];
            south = std::max(south, p0.z);
            north = std::min(north, p0.z);
            const bool is_over_water = std::abs(p0.z - 70) < 4;
            if (is_over_water && mesh.normals[i].y > 0.8F && std::abs(p0.x - 3) < 1.4F)
                lowest_deck_m = std::min(lowest_deck_m, p0.y);
        }
        EXPECT_TRUE(is_buildable(land, {3, south}));
        EXPECT_TRUE(is_buildable(land, {3, north}));
        EXPECT_GT(lowest_deck_m, spans[0].surface_m + 0.7F) << region;
    }
}

TEST(Bridges, WhereItIsShallowThereAreSteppingStonesOverTheWater) {
    const scene::Land land = land_of(0, 8, 0.25F);
    const Settled settled = one_lane_over(land);
    const std::vector<Span> spans = spans_of(land, settled);
    ASSERT_EQ(spans.size(), 1U);
    EXPECT_LE(spans[0].deepest_m, kFord_m);
    const std::vector<scene::Masses> fords = add_bridges(land, settled, {});
    ASSERT_EQ(fords.size(), 1U);
    float top_m = -1.0e9F;
    for (const glm::vec3& p : fords[0].mesh.positions_m)
        if (std::abs(p.z - 70) < 3) top_m = std::max(top_m, p.y);
    EXPECT_GT(top_m, spans[0].surface_m);
    EXPECT_LT(top_m, spans[0].surface_m + 0.4F);
}

TEST(Bridges, DryLanesNeedNone) {
    const scene::Land land = land_of(0);
    Settled settled;
    settled.lanes.push_back({{{0, 0}, {5, 0}, {10, 0}}, 2.6F, false, {}});
    EXPECT_TRUE(add_bridges(land, settled, {}).empty());
}

}  // namespace
}  // namespace quadrat::synthesis::houses
