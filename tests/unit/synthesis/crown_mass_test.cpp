// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "base/seed.hpp"
#include "mesh/nearness.hpp"
#include "mesh/pieces.hpp"
#include "support/manifold.hpp"
#include "synthesis/trees/crown_fringe.hpp"
#include "synthesis/trees/crown_lumps.hpp"
#include "synthesis/trees/crown_mass.hpp"
#include "synthesis/trees/crown_outline.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/undergrowth.hpp"

namespace quadrat::synthesis::trees {
namespace {

// Blades on a sphere's surface, of a third of a metre each way.
scene::Leaves blades_on_a_ball(std::size_t blades) {
    scene::Leaves leaves;
    base::RandomStream random{base::Seed{8}};
    for (std::size_t i = 0; i < blades; ++i) {
        glm::vec3 out{random.normal(), random.normal(), random.normal()};
        out = glm::normalize(out);
        BladeShape blade;
        blade.site_m = glm::vec3{0, 5, 0} + 2.0F * std::cbrt(random.unit_f()) * out;
        blade.along = out;
        blade.face = glm::normalize(glm::cross(out, glm::vec3{0.3F, 1, 0.2F}));
        scene::Leaves::Vertex common;
        common.colour = {0.2F, 0.4F, 0.1F};
        common.shade = 0.5F;
        add_blade(leaves, leaf_shape(LeafKind::Ovate), blade, common);
        ++leaves.blades;
    }
    return leaves;
}

TEST(CrownMass, StandsWhereLeavesAreDenseInTheirColours) {
    const auto masses = crown_masses(blades_on_a_ball(3500));
    ASSERT_GE(masses.size(), 2U);
    EXPECT_LE(masses.back().mesh.triangle_count(), 32U);
    EXPECT_GT(masses.front().share, 0.6F);
    const double ball_m3 = 4.18879 * 8;
    EXPECT_NEAR(tests::volume_of(masses.front().mesh), ball_m3, 0.45 * ball_m3);
    for (std::size_t i = 0; i < masses.front().colours.size(); ++i) {
        // As light as its leaves, but for a mottle.
        const glm::vec3 share = masses.front().colours[i] / glm::vec3(0.2F, 0.4F, 0.1F);
        EXPECT_NEAR(share.r, share.g, 0.03F);
        EXPECT_NEAR(share.g, 1, 0.35F);
        const glm::vec3 out = masses.front().mesh.positions_m[i] - glm::vec3{0, 5, 0};
        EXPECT_GT(glm::dot(masses.front().mesh.normals[i], glm::normalize(out)), 0.3F);
    }
}

TEST(CrownMass, OfABallIsAHeapAndNoBall) {
    const auto masses = crown_masses(blades_on_a_ball(3500));
    float sum = 0;
    float sum2 = 0;
    const auto& positions = masses.front().mesh.positions_m;
    for (const glm::vec3& at_m : positions) {
        const float radius = glm::distance(at_m, glm::vec3{0, 5, 0});
        sum += radius;
        sum2 += radius * radius;
    }
    const auto count = static_cast<float>(positions.size());
    const float mean = sum / count;
    const float deviation = std::sqrt(std::max(sum2 / count - mean * mean, 0.0F));
    EXPECT_GT(deviation, 0.04F * mean);
    EXPECT_LT(deviation, 0.20F * mean);
}

TEST(CrownLumps, AreSmoothEvenAndLightOnTop) {
    const CrownLumps lumps({-3, 2, -3}, {3, 9, 3});
    base::RandomStream random{base::Seed{5}};
    double mean = 0;
    constexpr int kPlaces = 4000;
    for (int i = 0; i < kPlaces; ++i) {
        const glm::vec3 at{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
        const float here = lumps.at(at);
        mean += here / kPlaces;
        ASSERT_LE(std::abs(here), 1);
        EXPECT_NEAR(lumps.at(at + 0.001F), here, 0.01F);
        EXPECT_EQ(lumps.light(at) > 1, here > 0);
        EXPECT_NEAR(glm::length(lumps.normal(at, {0, 1, 0})), 1, 1e-4F);
    }
    EXPECT_NEAR(mean, 0, 0.05);
}

float area_of(const mesh::Mesh& mesh) {
    float sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions_m[mesh.indices[i + k]]; };
        sum += 0.5F * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    return sum;
}

scene::Leaves nine_clumps() {
    scene::Leaves clumps;
    for (int i = 0; i < 9; ++i) {
        const scene::Leaves one = blades_on_a_ball(2600);
        const auto first = static_cast<std::uint32_t>(clumps.vertices.size());
        const glm::vec3 aside{11.0F * static_cast<float>(i % 3), 0, 11.0F * static_cast<float>(i / 3)};
        for (scene::Leaves::Vertex v : one.vertices) {
            v.site_m += aside;
            clumps.vertices.push_back(v);
        }
        for (const std::uint32_t index : one.indices) clumps.indices.push_back(first + index);
        clumps.blades += one.blades;
    }
    return clumps;
}

TEST(CrownFringe, StandsOffTheMassAndIsGoneWithIt) {
    auto masses = crown_masses(blades_on_a_ball(3500));
    const auto bare = masses;
    add_fringe(masses);
    EXPECT_EQ(masses.front().sprays, 7 * bare.front().mesh.triangle_count());
    const float crown_m2 = area_of(bare.front().mesh);
    float before_m2 = 2.1F * crown_m2;
    ASSERT_GE(masses.size(), bare.size());
    std::size_t of_bare = 0;  // of which there are several with ever fewer sprays
    for (std::size_t level = 0; of_bare < bare.size(); ++level) {
        ASSERT_LT(level, masses.size());
        const scene::CrownMass& mass = masses[level];
        const std::size_t own = mass.mesh.triangle_count() - mass.sprays;
        EXPECT_EQ(own, bare[of_bare].mesh.triangle_count());
        if (level + 1 == masses.size() || masses[level + 1].mesh.triangle_count() - masses[level + 1].sprays < own)
            ++of_bare;
        if (level + 1 < masses.size() && mass.sprays >= 48) {
            EXPECT_GE(4 * masses[level + 1].mesh.triangle_count(), mass.mesh.triangle_count()) << "a gap";
        }
        EXPECT_EQ(mass.coarser_m.empty(), level + 1 == masses.size());
        mesh::Mesh fringe = mass.mesh;
        fringe.indices.erase(fringe.indices.begin(), fringe.indices.end() - static_cast<long>(3 * mass.sprays));
        if (mass.sprays == 0) continue;
        // They cover the crown, but where that would take spikes; what a level lacks has become points.
        const float covered_m2 = area_of(fringe);
        EXPECT_LT(covered_m2, 1.05F * before_m2) << level;
        EXPECT_GT(covered_m2, std::min(1.5F, 0.008F * static_cast<float>(mass.sprays)) * crown_m2) << level;
        const float largest = mass.sprays > 24 ? 0.018F : 0.04F;
        EXPECT_LT(covered_m2, largest * crown_m2 * static_cast<float>(mass.sprays)) << level;
        before_m2 = covered_m2;
        for (std::size_t i = 0; i < fringe.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return fringe.positions_m[fringe.indices[i + k]]; };
            const glm::vec3 front = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            EXPECT_GT(glm::dot(front, fringe.normals[fringe.indices[i]]), 0) << "a spray seen from behind";
        }
        if (mass.coarser_m.empty()) continue;
        mesh::Mesh become = fringe;
        become.positions_m = mass.coarser_m;
        const bool has_next = level + 1 < masses.size() && masses[level + 1].sprays > 0;
        EXPECT_NEAR(area_of(become), has_next ? covered_m2 : 0, 0.9F * covered_m2) << level;
    }
    // From far enough no spray shows: an outline as wide as the crown was.
    EXPECT_EQ(masses.back().mesh.triangle_count(), kPlainOutline.triangles());
    EXPECT_EQ(masses.back().sprays, 0U);
    EXPECT_NEAR(std::cbrt(tests::volume_of(masses.back().mesh)), std::cbrt(tests::volume_of(bare.front().mesh)),
                0.35F * std::cbrt(tests::volume_of(bare.front().mesh)));
}

TEST(CrownMass, OfManyClumpsHasFewerAndLargerOnesFarAway) {
    const auto masses = crown_masses(nine_clumps());
    ASSERT_GE(masses.size(), 3U);
    EXPECT_GE(mesh::pieces_of(masses.front().mesh).size(), 5U);
    EXPECT_LE(masses.back().mesh.triangle_count(), 32U);
    int fewer = 0;
    for (std::size_t i = 1; i < masses.size(); ++i) {
        EXPECT_LE(masses[i].mesh.triangle_count(), (3 * masses[i - 1].mesh.triangle_count()) / 4) << i;
        const std::size_t left = mesh::pieces_of(masses[i].mesh).size();
        if (left == mesh::pieces_of(masses[i - 1].mesh).size()) continue;  // each of them is simpler
        EXPECT_GT(area_of(masses[i].mesh), 0.5F * area_of(masses[i - 1].mesh)) << i;
        ++fewer;
    }
    EXPECT_GE(fewer, 1);
}

// What a clump that is left out has become is a point: it has no surface any more.
TEST(CrownMass, EndsOnTheNextLevelsSurface) {
    for (const scene::Leaves& leaves : {blades_on_a_ball(3500), nine_clumps()}) {
        const auto masses = crown_masses(leaves);
        ASSERT_GE(masses.size(), 2U);
        for (std::size_t level = 0; level + 1 < masses.size(); ++level) {
            const scene::CrownMass& mass = masses[level];
            ASSERT_EQ(mass.coarser_m.size(), mass.mesh.positions_m.size()) << level;
            mesh::Mesh become = mass.mesh;
            become.positions_m = mass.coarser_m;
            const mesh::Nearness next(masses[level + 1].mesh);
            for (std::size_t i = 0; i < become.indices.size(); i += 3) {
                const auto corner = [&](std::size_t k) { return become.positions_m[become.indices[i + k]]; };
                const bool is_point = corner(0) == corner(1) && corner(1) == corner(2);
                for (std::size_t k = 0; k < 3 && !is_point; ++k)
                    EXPECT_LT(next.distance_m(corner(k)), 1e-3F) << level << " " << i;
            }
            EXPECT_NEAR(area_of(become), area_of(masses[level + 1].mesh), 1e-2F * area_of(become)) << level;
        }
        EXPECT_TRUE(masses.back().coarser_m.empty());
    }
}

// A cone 20 m high and 4 m wide at its foot, with less at its top.
TEST(CrownMass, OfASpireIsASpireAtItsCoarsest) {
    scene::Leaves leaves = blades_on_a_ball(9000);
    for (scene::Leaves::Vertex& v : leaves.vertices) {
        const glm::vec3 in_ball = (v.site_m - glm::vec3{0, 5, 0}) / 2.0F;
        const float height = 0.5F + 0.5F * in_ball.y;
        const float wide_m = 4 * (1 - 0.9F * height) / std::sqrt(std::max(1 - in_ball.y * in_ball.y, 0.05F));
        v.site_m = {wide_m * in_ball.x, 2 + 20 * height, wide_m * in_ball.z};
    }
    auto masses = crown_masses(leaves);
    ASSERT_FALSE(masses.empty());
    masses.resize(1);
    for (const Outline& outline : {kRoundOutline, kPlainOutline}) {
        add_outline(masses, outline);
        ASSERT_EQ(masses.back().mesh.triangle_count(), outline.triangles());
        EXPECT_GT(tests::volume_of(masses.back().mesh), 0.3 * tests::volume_of(masses.front().mesh));
        // As wide as the crown is at the height of each of its corners.
        for (const glm::vec3& corner_m : masses.back().mesh.positions_m) {
            float widest_m = 0;
            for (const glm::vec3& at_m : masses.front().mesh.positions_m)
                if (std::abs(at_m.y - corner_m.y) < 2.5F) widest_m = std::max(widest_m, std::hypot(at_m.x, at_m.z));
            EXPECT_LT(std::hypot(corner_m.x, corner_m.z), 1.05F * widest_m) << corner_m.y;
        }
    }
}

// A bush is a dozen pixels high in most pictures, on bare ground: a smooth ball there is the first thing that is seen.
TEST(CrownMass, OfABushIsNoBallFarAway) {
    std::vector<float> uneven;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const scene::Species bush = shrub({}, base::Seed{seed});
        std::size_t sprayed = 0;
        for (const scene::CrownMass& mass : bush.masses) {
            const std::size_t triangles = mass.mesh.triangle_count();
            sprayed += triangles < 80 && mass.sprays > 15;
            if (mass.sprays > 0 || triangles > 40) continue;
            std::vector<float> off_m;
            glm::vec3 middle_m{0};
            for (const glm::vec3& at_m : mass.mesh.positions_m) middle_m += at_m;
            middle_m /= static_cast<float>(mass.mesh.positions_m.size());
            for (const glm::vec3& at_m : mass.mesh.positions_m)
                off_m.push_back(glm::length((at_m - middle_m) * glm::vec3{1, 0, 1}));
            std::ranges::sort(off_m);
            off_m.erase(off_m.begin(), off_m.begin() + 2);  // the points above and below
            uneven.push_back(off_m.back() / off_m.front());
        }
        EXPECT_GE(sprayed, 1) << seed;
    }
    ASSERT_FALSE(uneven.empty());
    EXPECT_GT(std::accumulate(uneven.begin(), uneven.end(), 0.0F) / static_cast<float>(uneven.size()), 1.75F);
}

TEST(CrownMass, IsNotThereWhereTheSkyShinesThrough) {
    EXPECT_TRUE(crown_masses(blades_on_a_ball(12)).empty());
    EXPECT_TRUE(crown_masses({}).empty());
}

}  // namespace
}  // namespace quadrat::synthesis::trees
