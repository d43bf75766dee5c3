// SPDX-License-Identifier: Apache-2.0
#include "synthesis/voxels/climber.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/styles.hpp"
#include "synthesis/trees/overgrown.hpp"

namespace quadrat::synthesis::voxels {
namespace {

using trees::mix_in;

using Kind = Surroundings::Kind;

void add_quad(Surroundings& to, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
              Kind kind) {
    to.add_face(a, b, c, kind);
    to.add_face(a, c, d, kind);
}

constexpr glm::vec3 kWindowLow{2.5F, 1.2F, 0};
constexpr glm::vec3 kWindowHigh{3.7F, 2.6F, 0};

// Looks toward +z; eight metres by five, with a window.
Surroundings wall() {
    Surroundings around({-0.5F, -0.5F, -1}, {8.5F, 5.5F, 1.5F}, 0.3F);
    add_quad(around, {0, 0, 0}, {8, 0, 0}, {8, 5, 0}, {0, 5, 0}, Kind::Hold);
    add_quad(around, kWindowLow, {kWindowHigh.x, kWindowLow.y, 0}, kWindowHigh, {kWindowLow.x, kWindowHigh.y, 0},
             Kind::Bare);
    return around;
}

std::vector<Tendril> up_the_wall(std::uint64_t seed, std::size_t most = 260) {
    Climber climber;
    climber.most = most;
    climber.high_m = 4;
    climber.upward = 0.2F;
    climber.branching = 0.6F;
    const std::array roots{glm::vec3{0.6F, 0.1F, 0}, glm::vec3{5, 0.1F, 0}};
    return climb(wall(), roots, climber, base::Seed{seed});
}

TEST(Climber, KeepsToItsWallAndOffTheWindow) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<Tendril> shoots = up_the_wall(seed);
        ASSERT_GT(shoots.size(), 80U) << seed;
        float highest = 0;
        for (const Tendril& t : shoots) {
            EXPECT_NEAR(t.at_m.z, 0.03F, 1e-3F) << "it lies on the wall";
            EXPECT_NEAR(glm::dot(t.out, glm::vec3{0, 0, 1}), 1, 1e-4F);
            const glm::vec3 off = glm::max(glm::max(kWindowLow - t.at_m, t.at_m - kWindowHigh), glm::vec3{0});
            EXPECT_GT(std::max(off.x, off.y), 0.05F) << "it covers no pane";
            EXPECT_TRUE(t.at_m.x > -0.31F && t.at_m.x < 8.31F) << "nor grows where there is nothing to hold";
            highest = std::max(highest, t.at_m.y);
        }
        EXPECT_LE(highest, 4.2F);
        EXPECT_GT(highest, 2) << "but up";
    }
}

TEST(Climber, GrowsFromItsRootsStepByStep) {
    const std::vector<Tendril> shoots = up_the_wall(3);
    int roots = 0;
    for (std::size_t i = 0; i < shoots.size(); ++i) {
        const int before = shoots[i].before;
        ASSERT_LT(before, static_cast<int>(i));
        if (before < 0) {
            ++roots;
            continue;
        }
        EXPECT_LT(glm::distance(shoots[i].at_m, shoots[static_cast<std::size_t>(before)].at_m), 0.65F);
    }
    EXPECT_EQ(roots, 2);
    // Out of its own way: no two in one cell.
    std::set<std::array<int, 3>> cells;
    const Surroundings around = wall();
    for (const Tendril& t : shoots) {
        const glm::ivec3 c = around.cell_of(t.at_m);
        EXPECT_TRUE(cells.insert({c.x, c.y, c.z}).second);
    }
}

TEST(Climber, IsTheSameEachTimeAndEndsWhereItIsTold) {
    const std::vector<Tendril> one = up_the_wall(5), again = up_the_wall(5), other = up_the_wall(6);
    ASSERT_EQ(one.size(), again.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].at_m, again[i].at_m);
    EXPECT_NE(one.back().at_m, other.back().at_m);
    EXPECT_EQ(up_the_wall(5, 40).size(), 40U);
    const std::array nowhere{glm::vec3{4, 2, 1.4F}};
    EXPECT_TRUE(climb(wall(), nowhere, {}, base::Seed{1}).empty()) << "nothing there to hold on to";
}

TEST(Climber, GoesAroundCorners) {
    Surroundings around({-1, -0.5F, -4}, {4, 4.5F, 1}, 0.3F);
    add_quad(around, {0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}, Kind::Hold);
    add_quad(around, {3, 0, 0}, {3, 0, -3}, {3, 4, -3}, {3, 4, 0}, Kind::Hold);
    Climber climber;
    climber.most = 200;
    climber.upward = 0.1F;
    climber.branching = 0.6F;
    const std::array root{glm::vec3{2.6F, 0.1F, 0}};
    int beside = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        for (const Tendril& t : climb(around, root, climber, base::Seed{seed})) beside += t.out.x > 0.9F;
    EXPECT_GT(beside, 20);
}

scene::Leaves blades(std::size_t count, float red) {
    scene::Leaves leaves;
    for (std::size_t i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
        scene::Leaves::Vertex vertex;
        vertex.colour = {red, static_cast<float>(i), 0};
        leaves.vertices.insert(leaves.vertices.end(), 3, vertex);
        leaves.indices.insert(leaves.indices.end(), {first, first + 1, first + 2});
        ++leaves.blades;
    }
    return leaves;
}

TEST(Overgrown, EveryPrefixHasItsShareOfBoth) {
    scene::Leaves mixed = blades(90, 0);
    mix_in(mixed, blades(30, 1));
    ASSERT_EQ(mixed.blades, 120U);
    ASSERT_EQ(mixed.indices.size(), 360U);
    float others = 0;
    for (std::size_t i = 0; i < mixed.blades; ++i) {
        others += mixed.vertices[mixed.indices[3 * i]].colour.r;
        EXPECT_NEAR(others, 0.25F * static_cast<float>(i + 1), 1) << i;
    }
    scene::Leaves none;
    mix_in(none, blades(4, 1));
    EXPECT_EQ(none.blades, 4U);
}

// A house's climbers are faces of leaves; with none there are none.
std::size_t leafy_faces(float share) {
    scene::LandParameters p;
    p.climber_share = share;
    p.climber_height = 1;
    std::size_t leafy = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const scene::Building building = houses::build(
            houses::Stock(p, base::Seed{seed}).draw(houses::Use::Dwelling, base::Seed{seed}).design, base::Seed{seed});
        leafy +=
            static_cast<std::size_t>(std::ranges::count(building.levels.front().claddings, scene::Cladding::Leaves));
    }
    return leafy;
}

TEST(Overgrown, HousesAreAsTheGeneSays) {
    EXPECT_EQ(leafy_faces(0), 0U);
    EXPECT_GT(leafy_faces(1), 500U);
}

}  // namespace
}  // namespace quadrat::synthesis::voxels
