// SPDX-License-Identifier: Apache-2.0
#include "mesh/roam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "base/seed.hpp"

namespace quadrat::mesh {
namespace {

constexpr float kCell_m = 2;

Field rugged(int side) {
    Field field(side, side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            field.at(column, row) =
                6 * std::sin(0.11F * static_cast<float>(column)) * std::cos(0.07F * static_cast<float>(row)) +
                base::unit_of(base::hash_of(base::Seed{9}, column, row)) * (column > side / 2 ? 3.0F : 0.02F);
    return field;
}

std::vector<std::uint32_t> indices_of(const Roam& roam) {
    std::vector<std::uint32_t> indices;
    EXPECT_EQ(roam.append_indices({}, indices), roam.triangle_count());
    return indices;
}

// Triangles, each from its least corner, as a set: what does not depend on the order.
std::set<std::array<std::uint32_t, 3>> triangles_of(const Roam& roam) {
    const auto indices = indices_of(roam);
    std::set<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<std::uint32_t, 3> t{indices[i], indices[i + 1], indices[i + 2]};
        std::rotate(t.begin(), std::ranges::min_element(t), t.end());
        triangles.insert(t);
    }
    return triangles;
}

// A path over the land and away from it, near the ground and high up.
glm::vec3 eye_at(int frame) {
    const float t = 0.05F * static_cast<float>(frame);
    return {90 * std::sin(t), 20 + 15 * std::sin(2.3F * t), 90 * std::cos(0.7F * t)};
}

void expect_no_cracks(const Roam& roam, int side) {
    const auto indices = indices_of(roam);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    long twice_area = 0;
    const auto column = [&](std::uint32_t i) { return static_cast<int>(i) % side; };
    const auto row = [&](std::uint32_t i) { return static_cast<int>(i) / side; };
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{indices[i + k], indices[i + (k + 1) % 3]}];
        const std::uint32_t a = indices[i];
        const std::uint32_t b = indices[i + 1];
        const std::uint32_t c = indices[i + 2];
        // Rows run south, so counter-clockwise seen from above is negative here.
        const long twice = -((column(b) - column(a)) * (row(c) - row(a)) - (column(c) - column(a)) * (row(b) - row(a)));
        EXPECT_GT(twice, 0);
        twice_area += twice;
    }
    EXPECT_EQ(twice_area, 2L * (side - 1) * (side - 1));
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        const auto [a, b] = edge;
        const bool is_rim = (column(a) == column(b) && (column(a) == 0 || column(a) == side - 1)) ||
                            (row(a) == row(b) && (row(a) == 0 || row(a) == side - 1));
        EXPECT_EQ(edges.contains({b, a}), !is_rim);
    }
}

TEST(Roam, HasNoCracksHoweverTheEyeMoves) {
    for (const int side : {65, 49, 2, 8}) {  // 49: three by three squares of 16 cells
        Roam roam(rugged(side), kCell_m);
        for (int frame = 0; frame < 60; frame += 4) {
            roam.update({eye_at(frame), 500, 1.5F});
            expect_no_cracks(roam, side);
        }
    }
}

TEST(Roam, LiesWithinTheErrorAskedFor) {
    const Field field = rugged(65);
    Roam roam(field, kCell_m);
    for (const float error_px : {0.5F, 2.0F, 8.0F}) {
        const Roam::Wish wish{eye_at(7), 500, error_px};
        roam.update(wish);
        const auto indices = indices_of(roam);
        // Every sample against the triangle over it, seen from as near as it can be.
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            std::array<glm::vec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = {static_cast<float>(indices[i + k] % 65), field.samples[indices[i + k]],
                        static_cast<float>(indices[i + k] / 65)};
            const glm::vec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
            const glm::vec3 low = glm::min(p[0], glm::min(p[1], p[2]));
            const glm::vec3 high = glm::max(p[0], glm::max(p[1], p[2]));
            for (float z = low.z; z <= high.z; ++z) {
                for (float x = low.x; x <= high.x; ++x) {
                    bool is_in = true;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const glm::vec3 a = p[k];
                        const glm::vec3 b = p[(k + 1) % 3];
                        is_in = is_in && (b.z - a.z) * (x - a.x) - (b.x - a.x) * (z - a.z) >= 0;
                    }
                    if (!is_in) continue;
                    const float height = p[0].y - (n.x * (x - p[0].x) + n.z * (z - p[0].z)) / n.y;
                    const float truth = field.at(static_cast<int>(x), static_cast<int>(z));
                    const glm::vec3 at_m{(x - 32) * kCell_m, truth, (z - 32) * kCell_m};
                    const float distance_m = glm::distance(at_m, wish.eye_m);
                    EXPECT_LE(std::abs(height - truth) * 500 / distance_m, 1.001F * error_px + 1e-3F);
                }
            }
        }
    }
}

TEST(Roam, IsTheSameAfterAFlightAsFromNothing) {
    const Field field = rugged(129);
    Roam flown(field, kCell_m);
    for (int frame = 0; frame < 150; ++frame) {
        const Roam::Wish wish{eye_at(frame), 500, 2};
        flown.update(wish);
        if (frame % 10 != 9) continue;
        Roam fresh(field, kCell_m);
        fresh.update(wish);
        EXPECT_EQ(triangles_of(flown), triangles_of(fresh)) << frame;
    }
}

TEST(Roam, MergesWhatItHasSplit) {
    Roam roam(rugged(65), kCell_m);
    roam.update({{0, 1e6F, 0}, 500, 2});
    const auto far = triangles_of(roam);
    EXPECT_EQ(far.size(), 2U);
    roam.update({{0, 10, 0}, 500, 2});
    EXPECT_GT(roam.triangle_count(), 1000U);
    roam.update({{0, 1e6F, 0}, 500, 2});
    EXPECT_EQ(triangles_of(roam), far);
}

TEST(Roam, HoldsItsBudgetAndComesBack) {
    Roam roam(rugged(129), kCell_m);
    Roam::Wish wish{{0, 30, 0}, 500, 1};
    roam.update(wish);
    const std::size_t whole = roam.triangle_count();
    wish.triangle_budget = whole / 8;
    for (int frame = 0; frame < 40; ++frame) {
        wish.eye_m = eye_at(frame);
        roam.update(wish);
        EXPECT_LE(roam.triangle_count(), wish.triangle_budget);
        EXPECT_GE(roam.error_px(), 1);
    }
    wish.triangle_budget = 4 * whole;
    wish.eye_m = {0, 30, 0};
    for (int frame = 0; frame < 40; ++frame) roam.update(wish);
    EXPECT_EQ(roam.error_px(), 1);
    EXPECT_EQ(roam.triangle_count(), whole);
}

TEST(Roam, ItsBudgetIsOfWhatThePlanesLeave) {
    Roam roam(rugged(129), kCell_m);
    const std::array<glm::vec4, 1> west{glm::vec4{-1, 0, 0, 0}};
    Roam::Wish wish{{-30, 10, 0}, 500, 1, 2000};
    roam.update(wish);
    const float of_all_px = roam.error_px();
    wish.planes = west;
    roam.update(wish);
    std::vector<std::uint32_t> seen;
    EXPECT_LE(roam.append_indices(west, seen), wish.triangle_budget);
    EXPECT_GT(roam.triangle_count(), wish.triangle_budget);
    EXPECT_LT(roam.error_px(), of_all_px) << "finer where it counts";
}

// Whatever it was held to before: at once as fine as for an eye that was always there, but for one step of its error.
TEST(Roam, ComesBackAtOnceWhereTheEyeJumpsAway) {
    Roam roam(rugged(129), kCell_m);
    const std::array<glm::vec4, 1> east{glm::vec4{1, 0, 0, 0}};
    const std::array<glm::vec4, 1> nothing{glm::vec4{1, 0, 0, -1e6F}};
    Roam::Wish wish{{30, 10, 0}, 500, 1, 500, east};
    roam.update(wish);
    EXPECT_GT(roam.error_px(), 4);
    wish.planes = nothing;
    roam.update(wish);
    EXPECT_EQ(roam.error_px(), 1);
}

// On the map: along any way from the eye, whose every triangle may hide those after it.
TEST(Roam, GivesWhatMayHideBeforeWhatItMayHide) {
    constexpr int kSide = 65;
    Roam roam(rugged(kSide), kCell_m);
    for (const glm::vec2 eye : {glm::vec2{-21.3F, 7.7F}, {90.1F, -10.3F}, {3.3F, -88.9F}, {-70.7F, 80.3F}}) {
        roam.update({{eye.x, 12, eye.y}, 500, 6});
        const auto indices = indices_of(roam);
        const auto corner = [&](std::size_t i) {
            const glm::vec3 place_m = roam.place_m(indices[i]);
            return glm::vec2{place_m.x, place_m.z};
        };
        const auto at = [&](glm::vec2 place) {
            for (std::size_t i = 0; i < indices.size(); i += 3) {
                bool is_in = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    const glm::vec2 a = corner(i + k);
                    const glm::vec2 edge = corner(i + (k + 1) % 3) - a;
                    is_in = is_in && edge.y * (place.x - a.x) - edge.x * (place.y - a.y) > 0;
                }
                if (is_in) return static_cast<int>(i);
            }
            return -1;  // outside, or on an edge
        };
        for (int turn = 0; turn < 24; ++turn) {
            const float azimuth = 0.262F * static_cast<float>(turn) + 0.1F;
            int last = -1;
            for (float gone_m = 0.1F; gone_m < 260; gone_m += 1.7F) {
                const int found = at(eye + gone_m * glm::vec2{std::cos(azimuth), std::sin(azimuth)});
                if (found < 0) continue;
                EXPECT_GE(found, last) << turn << ", " << gone_m << " m";
                last = found;
            }
        }
    }
}

TEST(Roam, LeavesOutWhatLiesBehindAPlane) {
    Roam roam(rugged(65), kCell_m);
    roam.update({{0, 20, 0}, 500, 2});
    const auto all = indices_of(roam);
    const std::array<glm::vec4, 1> east{glm::vec4{1, 0, 0, 0}};
    std::vector<std::uint32_t> seen;
    const std::size_t count = roam.append_indices(east, seen);
    EXPECT_LT(count, roam.triangle_count());
    std::size_t needed = 0;
    for (std::size_t i = 0; i < all.size(); i += 3)
        needed += std::max({all[i] % 65, all[i + 1] % 65, all[i + 2] % 65}) > 32 ? 1U : 0U;
    EXPECT_GE(count, needed);
    EXPECT_LE(count, needed + needed / 2);
}

}  // namespace
}  // namespace quadrat::mesh
