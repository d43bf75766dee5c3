// SPDX-License-Identifier: Apache-2.0
#include "mesh/progressive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "mesh/displaced_sphere.hpp"
#include "mesh/nearness.hpp"
#include "support/manifold.hpp"

namespace quadrat::mesh {
namespace {

const Mesh& ball() {
    static const Mesh kBall = displaced_sphere(32, base::Seed{7});  // 4098 vertices
    return kBall;
}

// A rectangle of cells, or a tube of them: then its first column is there twice, with other texture coordinates.
Mesh sheet(int columns, int rows, bool is_tube) {
    Mesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(columns);
            const float v = static_cast<float>(row) / static_cast<float>(rows);
            const float turn = column == columns ? 0 : 2 * std::numbers::pi_v<float> * u;
            const float radius = 0.3F - 0.2F * v * v;
            mesh.positions_m.push_back(is_tube ? glm::vec3{radius * std::cos(turn), v, -radius * std::sin(turn)}
                                               : glm::vec3{u, 0, -v});
            mesh.texcoords.emplace_back(u, v);
        }
    }
    const auto at = [&](int column, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            mesh.indices.insert(mesh.indices.end(),
                                {at(column, row), at(column + 1, row), at(column, row + 1), at(column, row + 1),
                                 at(column + 1, row), at(column + 1, row + 1)});
    return mesh;
}

float area_of(const Mesh& mesh) {
    float area = 0;
    const auto& p = mesh.positions_m;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        area += 0.5F * glm::length(glm::cross(p[mesh.indices[i + 1]] - p[mesh.indices[i]],
                                              p[mesh.indices[i + 2]] - p[mesh.indices[i]]));
    return area;
}

// How often each edge is met from one side without the other, vertices at one place taken as one.
std::size_t open_edges(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, int> places;
    const auto place = [&](std::uint32_t v) {
        const glm::vec3 p = mesh.positions_m[v];
        return places.try_emplace({p.x, p.y, p.z}, static_cast<int>(places.size())).first->second;
    };
    std::map<std::pair<int, int>, int> sides;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++sides[{place(mesh.indices[i + k]), place(mesh.indices[i + (k + 1) % 3])}];
    return static_cast<std::size_t>(std::ranges::count_if(sides, [&](const auto& side) {
        return !sides.contains({side.first.second, side.first.first});
    }));
}

TEST(ProgressiveMesh, HalvesTheVerticesDownToAboutSixty) {
    const Progressive progressive = make_progressive(ball());
    EXPECT_EQ(progressive.end, Progressive::End::Reached);
    EXPECT_EQ(progressive.levels.front().mesh.positions_m, ball().positions_m);
    for (std::size_t i = 0; i + 1 < progressive.levels.size(); ++i) {
        const std::size_t before = progressive.levels[i].mesh.positions_m.size();
        EXPECT_EQ(progressive.levels[i + 1].mesh.positions_m.size(), (before + 1) / 2);
    }
    EXPECT_GE(progressive.levels.back().mesh.positions_m.size(), 42U);
    EXPECT_LE(progressive.levels.back().mesh.positions_m.size(), 85U);
}

TEST(ProgressiveMesh, StaysClosedAndFacesOutwardAtEveryLevel) {
    for (const Progressive::Level& level : make_progressive(ball()).levels) {
        const Mesh& mesh = level.mesh;
        EXPECT_EQ(tests::manifold_fault(mesh.indices, mesh.positions_m.size()), "");
        EXPECT_EQ(tests::degenerate_triangles(mesh), 0U);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions_m[mesh.indices[i]];
            const glm::vec3 b = mesh.positions_m[mesh.indices[i + 1]];
            const glm::vec3 c = mesh.positions_m[mesh.indices[i + 2]];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0);
        }
        for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-4F);
    }
}

// A trunk that bends, with ribs that run out into its foot: closed.
Mesh trunk() {
    constexpr int kSides = 40;
    constexpr int kRings = 120;
    Mesh mesh;
    for (int ring = 0; ring <= kRings; ++ring) {
        const float up = static_cast<float>(ring) / kRings;
        const float foot = std::exp(-9 * up);
        for (int side = 0; side < kSides; ++side) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
            const float radius = (0.4F - 0.28F * up) * (1 + foot * (0.5F + 0.4F * std::cos(5 * turn)));
            mesh.positions_m.push_back(
                {0.5F * up * up + radius * std::cos(turn), 9 * up, 0.3F * up - radius * std::sin(turn)});
        }
    }
    const auto at = [](int ring, int side) { return static_cast<std::uint32_t>(ring * kSides + side % kSides); };
    for (int ring = 0; ring < kRings; ++ring)
        for (int side = 0; side < kSides; ++side)
            mesh.indices.insert(mesh.indices.end(), {at(ring, side), at(ring, side + 1), at(ring + 1, side),
                                                     at(ring + 1, side), at(ring, side + 1), at(ring + 1, side + 1)});
    for (int side = 1; side + 1 < kSides; ++side)
        mesh.indices.insert(mesh.indices.end(), {at(0, 0), at(0, side + 1), at(0, side), at(kRings, 0),
                                                 at(kRings, side), at(kRings, side + 1)});
    return mesh;
}

TEST(ProgressiveMesh, KeepsATrunksVolumeWithinOnePercentAtHalfTheVerticesAndFiveAtASixteenth) {
    const Mesh whole = trunk();
    const double volume_m3 = tests::volume_of(whole);
    ASSERT_GT(volume_m3, 1);
    for (const Placement placement : {Placement::Line, Placement::Fitted}) {
        ProgressiveOptions options;
        options.placement = placement;
        const Progressive progressive = make_progressive(whole, options);
        ASSERT_GT(progressive.levels.size(), 4U);
        const auto volume_at = [&](std::size_t level) { return tests::volume_of(progressive.levels[level].mesh); };
        const auto vertices_at = [&](std::size_t level) {
            return static_cast<double>(progressive.levels[level].mesh.positions_m.size());
        };
        EXPECT_NEAR(vertices_at(1) / vertices_at(0), 1.0 / 2, 0.02);
        EXPECT_NEAR(volume_at(1), volume_m3, 0.01 * volume_m3);
        EXPECT_NEAR(vertices_at(4) / vertices_at(0), 1.0 / 16, 0.01);
        EXPECT_NEAR(volume_at(4), volume_m3, 0.05 * volume_m3);
    }
}

TEST(ProgressiveMesh, HasAParentNearEveryVertexAndNoParentWithoutOne) {
    const Progressive progressive = make_progressive(ball());
    for (std::size_t i = 0; i + 1 < progressive.levels.size(); ++i) {
        const Progressive::Level& level = progressive.levels[i];
        const std::size_t next = progressive.levels[i + 1].mesh.positions_m.size();
        ASSERT_EQ(level.parents.size(), level.mesh.positions_m.size());
        std::vector<int> children(next);
        for (const std::uint32_t parent : level.parents) {
            ASSERT_LT(parent, next);
            ++children[parent];
        }
        EXPECT_EQ(std::ranges::count(children, 0), 0);
        const auto targets = morph_targets_m(progressive, i);
        const float edge_m = 2 * std::sqrt(4 * std::numbers::pi_v<float> / static_cast<float>(next));
        for (std::size_t v = 0; v < targets.size(); ++v)
            EXPECT_LT(glm::distance(targets[v], level.mesh.positions_m[v]), 3 * edge_m);
    }
    EXPECT_TRUE(progressive.levels.back().parents.empty());
}

TEST(ProgressiveMesh, StandsForALengthInItsErrorWhateverTheSize) {
    Mesh large = ball();
    for (glm::vec3& p : large.positions_m) p *= 10.0F;
    const Progressive one = make_progressive(ball());
    const Progressive ten = make_progressive(large);
    ASSERT_EQ(one.levels.size(), ten.levels.size());
    for (std::size_t i = 1; i < one.levels.size(); ++i) {
        EXPECT_GT(one.levels[i].error_m, one.levels[i - 1].error_m);
        const float d = ideal_distance_m(one.levels[i], 500);
        EXPECT_NEAR(ideal_distance_m(ten.levels[i], 500), 10 * d, 0.5F * d);
        EXPECT_FLOAT_EQ(ideal_distance_m(one.levels[i], 1000), 2 * d);
    }
    // A power of two changes nothing at all.
    for (glm::vec3& p : large.positions_m) p *= 1.6F;
    const Progressive sixteen = make_progressive(large);
    for (glm::vec3& p : large.positions_m) p *= 4.0F;
    const Progressive sixty_four = make_progressive(large);
    for (std::size_t i = 0; i < sixteen.levels.size(); ++i) {
        EXPECT_EQ(sixty_four.levels[i].mesh.indices, sixteen.levels[i].mesh.indices);
        EXPECT_EQ(sixty_four.levels[i].error_m, 4 * sixteen.levels[i].error_m);
    }
}

TEST(ProgressiveMesh, ChoosesCoarserLevelsFartherAway) {
    const Progressive progressive = make_progressive(ball());
    EXPECT_EQ(level_at(progressive, 0, 500), 0);
    float before = 0;
    for (float distance_m = 0.1F; distance_m < 1000; distance_m *= 1.1F) {
        const float level = level_at(progressive, distance_m, 500);
        EXPECT_GE(level, before);
        EXPECT_LT(level - before, 0.5F);
        before = level;
    }
    EXPECT_EQ(before, static_cast<float>(progressive.levels.size() - 1));
    const float fourth_m = ideal_distance_m(progressive.levels[4], 500);
    EXPECT_FLOAT_EQ(level_at(progressive, fourth_m, 500), 4);
}

TEST(ProgressiveMesh, LiesNoFartherFromTheSurfaceThanItSays) {
    for (const Progressive::Level& level : make_progressive(ball()).levels)
        EXPECT_LE(deviation_of(level.mesh, ball()).rms_m, level.error_m + 1e-6F);
}

// What meshoptimizer 1.2 with update has on the same sphere, where errors are a share of the bounding box's diagonal.
TEST(ProgressiveMesh, ErrsNoMoreThanItsBestPeerFromAHundredThousandVertices) {
    struct Figure {
        std::size_t level;
        double vertices, rms_1e5;
    };
    const Mesh exact = displaced_sphere(159, base::Seed{1});
    const Progressive progressive = make_progressive(exact);
    ASSERT_GT(progressive.levels.size(), 9U);
    for (const Figure& figure :
         {Figure{1, 50'700, 8.7}, {3, 12'700, 28}, {5, 3'200, 68}, {7, 794, 156}, {9, 200, 336}}) {
        const Mesh& level = progressive.levels[figure.level].mesh;
        const auto vertices = static_cast<double>(level.positions_m.size());
        EXPECT_NEAR(vertices, figure.vertices, 0.02 * figure.vertices);
        EXPECT_LE(1e5 * deviation_of(level, exact).rms_m / diagonal_m(exact), figure.rms_1e5) << figure.vertices;
    }
}

TEST(ProgressiveMesh, KeepsAVertexOnTheLinesOfItsEdgesWhereAsked) {
    std::vector<float> places;
    for (const glm::vec3& p : ball().positions_m) places.insert(places.end(), {p.x, p.y, p.z});
    ProgressiveOptions options;
    options.placement = Placement::Line;
    options.attributes = places;
    options.attributes_a_vertex = 3;
    const Progressive progressive = make_progressive(ball(), options);
    ASSERT_GT(progressive.levels.size(), 5U);
    for (const Progressive::Level& level : progressive.levels) {
        ASSERT_EQ(level.attributes.size(), 3 * level.mesh.positions_m.size());
        for (std::size_t v = 0; v < level.mesh.positions_m.size(); ++v) {
            const glm::vec3 place{level.attributes[3 * v], level.attributes[3 * v + 1], level.attributes[3 * v + 2]};
            EXPECT_LT(glm::distance(place, level.mesh.positions_m[v]), 1e-4F);
        }
    }
}

TEST(ProgressiveMesh, NeverTearsABorder) {
    const Mesh flat = sheet(40, 30, false);
    const Progressive progressive = make_progressive(flat);
    for (const Progressive::Level& level : progressive.levels) {
        EXPECT_NEAR(area_of(level.mesh), 1, 1e-3F);
        EXPECT_LT(level.error_m, 1e-3F);
        for (std::size_t v = 0; v < level.mesh.positions_m.size(); ++v) {
            const glm::vec3 p = level.mesh.positions_m[v];
            EXPECT_LT(glm::distance(glm::vec3(level.mesh.texcoords[v].x, 0, -level.mesh.texcoords[v].y), p), 2e-3F);
        }
    }
    EXPECT_EQ(progressive.end, Progressive::End::Reached);
}

TEST(ProgressiveMesh, OpensNoSeam) {
    const Mesh tube = sheet(48, 40, true);
    ASSERT_EQ(open_edges(tube), 2U * 48);  // its ends
    const Progressive progressive = make_progressive(tube);
    ASSERT_GT(progressive.levels.size(), 3U);
    std::size_t before = 2U * 48;
    for (const Progressive::Level& level : progressive.levels) {
        const std::size_t open = open_edges(level.mesh);
        EXPECT_LE(open, before);
        before = open;
        float least = 1;
        float most = 0;
        for (std::size_t i = 0; i < level.mesh.indices.size(); i += 3) {
            // No triangle runs back across the seam's jump.
            float low = 1;
            float high = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                low = std::min(low, level.mesh.texcoords[level.mesh.indices[i + k]].x);
                high = std::max(high, level.mesh.texcoords[level.mesh.indices[i + k]].x);
            }
            EXPECT_LT(high - low, 0.7F);
            least = std::min(least, low);
            most = std::max(most, high);
        }
        EXPECT_EQ(least, 0);
        EXPECT_EQ(most, 1);
    }
}

TEST(ProgressiveMesh, KeepsMaterialsToTheirSides) {
    const Mesh flat = sheet(40, 30, false);
    std::vector<std::uint8_t> materials;
    for (std::size_t t = 0; t < flat.triangle_count(); ++t) materials.push_back(t % 80 < 32 ? 3 : 5);
    ProgressiveOptions options;
    options.materials = materials;
    for (const Progressive::Level& level : make_progressive(flat, options).levels) {
        ASSERT_EQ(level.materials.size(), level.mesh.triangle_count());
        EXPECT_NEAR(area_of(level.mesh), 1, 1e-3F);
        for (std::size_t i = 0; i < level.mesh.indices.size(); ++i) {
            const float x = level.mesh.positions_m[level.mesh.indices[i]].x;
            EXPECT_TRUE(level.materials[i / 3] == 3 ? x < 0.401F : x > 0.399F) << x;
        }
    }
}

TEST(ProgressiveMesh, EndsAtATetrahedronAndSaysSo) {
    ProgressiveOptions options;
    options.fewest = 1;
    const Progressive progressive = make_progressive(ball(), options);
    EXPECT_EQ(progressive.end, Progressive::End::AllAreRigid);
    const Mesh& last = progressive.levels.back().mesh;
    EXPECT_LE(last.positions_m.size(), 6U);
    EXPECT_GE(last.positions_m.size(), 4U);
    EXPECT_EQ(tests::manifold_fault(last.indices, last.positions_m.size()), "");
}

TEST(ProgressiveMesh, OfNothingIsNothing) {
    const Progressive progressive = make_progressive({});
    EXPECT_EQ(progressive.end, Progressive::End::NothingToDo);
    ASSERT_EQ(progressive.levels.size(), 1U);
    EXPECT_TRUE(progressive.levels.front().mesh.indices.empty());
}

TEST(Nearness, IsTheDistanceToTheNearestTriangle) {
    const Mesh flat = sheet(7, 5, false);
    const Nearness nearness(flat);
    EXPECT_NEAR(nearness.distance_m({0.3F, 0.2F, -0.4F}), 0.2F, 1e-6F);
    EXPECT_NEAR(nearness.distance_m({-0.3F, 0.4F, -0.5F}), 0.5F, 1e-6F);
    EXPECT_EQ(nearness.distance_m({0.5F, 0, -0.5F}), 0);
    EXPECT_GT(Nearness(Mesh{}).distance_m({0, 0, 0}), 1e30F);
}

TEST(Nearness, FindsAPointOfTheTriangleThatNoOtherIsNearerThan) {
    base::RandomStream random{base::Seed{12}};
    const auto anywhere = [&](float reach) {
        return glm::vec3{random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach)};
    };
    for (int i = 0; i < 3000; ++i) {
        // Of any shape, slivers too.
        const float size = std::exp2(random.between(-9, 2));
        Mesh one;
        one.positions_m = {anywhere(5), {}, {}};
        one.positions_m[1] = one.positions_m[0] + anywhere(size);
        one.positions_m[2] =
            i % 3 == 0 ? one.positions_m[1] + anywhere(0.001F * size) : one.positions_m[0] + anywhere(size);
        one.indices = {0, 1, 2};
        const glm::vec3 from = anywhere(8);
        const Nearness nearness(one);
        const Nearness::Nearest found = nearness.nearest(from);
        EXPECT_NEAR(found.distance_m, glm::distance(from, found.at_m), 1e-5F);
        EXPECT_LT(nearness.distance_m(found.at_m), 1e-5F);
        for (int k = 0; k < 40; ++k) {
            const float a = random.unit_f();
            const float b = (1 - a) * random.unit_f();
            const glm::vec3 other = a * one.positions_m[0] + b * one.positions_m[1] + (1 - a - b) * one.positions_m[2];
            EXPECT_LE(found.distance_m, glm::distance(from, other) + 1e-4F);
        }
    }
}

}  // namespace
}  // namespace quadrat::mesh
