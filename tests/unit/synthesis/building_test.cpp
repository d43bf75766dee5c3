// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/building.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "synthesis/houses/recesses.hpp"
#include "synthesis/houses/roofs.hpp"

namespace quadrat::synthesis::houses {
namespace {

double area_of(const Outline& outline) {
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 p = outline[i];
        const glm::dvec2 q = outline[(i + 1) % outline.size()];
        area += 0.5 * (p.x * q.y - p.y * q.x);
    }
    return area;
}

const FacadeGrammar& plain() {
    static const FacadeGrammar kPlain = read_facade(
        "name Plain\nFacade -> panel #e0e0e0 with Row\nRow -> repeat x 3 Bay\nBay -> inset 1 1 1 0.8 Glass\n"
        "Glass -> panel #304050 depth -0.1\n",
        "plain");
    return kPlain;
}

Design design(RoofForm form, const Footprint& footprint) {
    Design d;
    d.facade = &plain();
    d.footprint = footprint;
    d.form = form;
    d.chimneys = 0;
    if (form == RoofForm::Mansard || form == RoofForm::Gambrel) {
        d.pitch_deg = 66;
        d.eave_m = 0.25;
    }
    return d;
}

// How high the highest face of a level stands over a place; -1: nothing does.
float top_m(const scene::Masses& masses, glm::vec2 at) {
    float top = -1;
    const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
    for (std::size_t t = 0; t + 2 < masses.mesh.indices.size(); t += 3) {
        const glm::vec3& p = masses.mesh.positions_m[masses.mesh.indices[t]];
        const glm::vec3& q = masses.mesh.positions_m[masses.mesh.indices[t + 1]];
        const glm::vec3& r = masses.mesh.positions_m[masses.mesh.indices[t + 2]];
        const glm::vec2 a{p.x, p.z};
        const glm::vec2 b = glm::vec2{q.x, q.z} - a;
        const glm::vec2 c = glm::vec2{r.x, r.z} - a;
        const float area = cross(b, c);
        if (std::abs(area) < 1.0e-6F) continue;
        const float u = cross(at - a, c) / area;
        const float v = cross(b, at - a) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) top = std::max(top, p.y + u * (q.y - p.y) + v * (r.y - p.y));
    }
    return top;
}

TEST(Buildings, GlassIsSetBackInTheWallWhereItIsNear) {
    const scene::Building building = build(design(RoofForm::Gabled, rectangle(9, 7)), base::Seed{1});
    const auto farthest_south = [](const scene::Masses& masses) {
        float most = -1.0e9F;
        for (std::size_t i = 0; i < masses.lamps.size(); ++i)
            if (masses.lamps[i] > 0) most = std::max(most, masses.mesh.positions_m[i].z);
        return most;
    };
    EXPECT_LT(farthest_south(building.levels[0]), 3.5F - 0.12F);
    EXPECT_GT(farthest_south(building.levels[1]), 3.5F);
}

TEST(Buildings, AMansardRoofIsSteepBelowItsBreakAndFlatAbove) {
    const Design d = design(RoofForm::Mansard, rectangle(10, 8));
    const scene::Building building = build(d, base::Seed{1});
    const auto eaves = static_cast<float>(d.plinth_m + d.wall_m + over_walls_m(d));
    const scene::Masses& roof = building.levels[2];
    const auto run = static_cast<float>(d.break_m / std::tan(glm::radians(d.pitch_deg)));
    EXPECT_NEAR(top_m(roof, {0, 4 - 0.5F * run}), eaves + 0.5F * static_cast<float>(d.break_m), 0.02F);
    EXPECT_NEAR(top_m(roof, {0, 4 - run}), eaves + static_cast<float>(d.break_m), 0.02F);
    const auto upper = static_cast<float>(std::tan(glm::radians(d.upper_pitch_deg)));
    EXPECT_NEAR(top_m(roof, {0, 4 - run - 1}), eaves + static_cast<float>(d.break_m) + upper, 0.02F);
    EXPECT_NEAR(building.height_m, eaves + rise_m(d, 8), 0.02);
}

TEST(Buildings, AGambrelsWallEndsUnderItsRoof) {
    const Design d = design(RoofForm::Gambrel, rectangle(10, 8));
    const std::vector<glm::dvec2> gable = gable_of(d, 8);
    ASSERT_EQ(gable.size(), 3U);
    const scene::Building building = build(d, base::Seed{1});
    const scene::Masses& far = building.levels[2];
    for (const glm::dvec2 p : gable) {
        const float z = static_cast<float>(p.x) - 4;
        EXPECT_NEAR(top_m(far, {4.9F, z}), d.plinth_m + d.wall_m + over_walls_m(d) + p.y, 0.03) << p.x;
    }
}

TEST(Buildings, NothingOfAWallComesThroughTheRoof) {
    const FacadeGrammar trimmed = read_facade(
        "name Trimmed\nFacade -> panel #e0e0e0 with Body\nBody -> split y 1r Nothing, 0.2 Trim\n"
        "Trim -> panel #804020 depth 0.04\nNothing -> nothing\n",
        "trimmed");
    for (const RoofForm form : {RoofForm::Gabled, RoofForm::Hipped, RoofForm::HalfHipped})
        for (const double pitch_deg : {25.0, 45.0, 52.0}) {
            Design d = design(form, rectangle(9, 7));
            d.facade = &trimmed;
            d.pitch_deg = pitch_deg;
            const scene::Building building = build(d, base::Seed{5});
            const scene::Masses& all = building.levels.front();
            scene::Masses roof;
            roof.mesh.positions_m = all.mesh.positions_m;
            for (std::size_t t = 0; t + 2 < all.mesh.indices.size(); t += 3)
                if (all.claddings[all.mesh.indices[t]] == d.roof.cladding)
                    roof.mesh.indices.insert(roof.mesh.indices.end(), &all.mesh.indices[t], &all.mesh.indices[t] + 3);
            ASSERT_FALSE(roof.mesh.indices.empty());
            int under = 0;
            for (std::size_t i = 0; i < all.mesh.positions_m.size(); ++i) {
                if (all.claddings[i] == d.roof.cladding) continue;
                const glm::vec3& p = all.mesh.positions_m[i];
                const float over_m = top_m(roof, {p.x, p.z});
                if (over_m < 0) continue;
                ++under;
                EXPECT_LE(p.y, over_m + 1.0e-3F) << pitch_deg << " degrees";
            }
            EXPECT_GT(under, 20);
        }
}

TEST(Buildings, WingsAndShedsKeepWithinTheirRectangle) {
    for (const Wing wing : {Wing::BackCorner, Wing::BackMiddle, Wing::Front})
        for (const bool is_mirrored : {false, true}) {
            Footprint footprint = with_wing(rectangle(11, 7), wing, 5, 3);
            if (is_mirrored) footprint = mirrored(footprint);
            EXPECT_GT(area_of(footprint.plan), 11 * 7 + 5 * 3 - 1.0e-6);
            EXPECT_GT(footprint.plan[1].x, footprint.plan[0].x) << "the first side is the front";
            EXPECT_EQ(footprint.plan[1].y, footprint.plan[0].y);
            Design d = design(RoofForm::Gabled, footprint);
            d.lean_tos.push_back({2, 0.5, 3, 2, 2.6, 2});
            const scene::Building building = build(d, base::Seed{3});
            for (const scene::Masses& level : building.levels)
                for (const glm::vec3& p : level.mesh.positions_m) {
                    EXPECT_LE(std::abs(p.x), building.half_m.x + 1);
                    EXPECT_LE(std::abs(p.z), building.half_m.y + 1.3F) << "steps and eaves";
                }
        }
}

TEST(Buildings, ChimneysStandOnTheirRoof) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Design d = design(seed % 2 == 0 ? RoofForm::Gabled : RoofForm::Hipped,
                          with_wing(rectangle(11, 7), seed % 3 == 0 ? Wing::Front : Wing::BackMiddle, 5, 3));
        const scene::Building bare = build(d, base::Seed{seed});
        d.chimneys = 2;
        const scene::Building building = build(d, base::Seed{seed});
        ASSERT_FALSE(building.chimneys_m.empty());
        for (const glm::vec3& at : building.chimneys_m) {
            const float roof = top_m(bare.levels[2], {at.x, at.z});
            EXPECT_GT(roof, d.wall_m) << seed;
            EXPECT_GT(at.y, roof + 0.8F);
        }
    }
}

TEST(Buildings, WhatIsLeftOfAWallAndItsHolesAreTheWall) {
    base::RandomStream random{base::Seed{8}};
    const Outline gable{{0, 0}, {9, 0}, {9, 3}, {4.5, 7}, {0, 3}};
    for (int round = 0; round < 200; ++round) {
        std::vector<Opening> holes;
        double of_holes = 0;
        // In columns of their own, so that none overlap.
        for (int column = 0; column < 4; ++column) {
            const double x = 0.6 + 2 * column + random.between(0.0F, 0.5F);
            const double y = random.between(0.2F, 1.2F);
            holes.push_back({{x, y}, {x + random.between(0.3F, 1.2F), y + random.between(0.3F, 1.6F)}, false, 0});
            const glm::dvec2 size = holes.back().high_m - holes.back().low_m;
            of_holes += size.x * size.y;
        }
        double left = 0;
        for (const Outline& piece : without(gable, holes, {0.5, 2.15})) {
            left += area_of(piece);
            for (const glm::dvec2 corner : piece)
                for (const Opening& hole : holes)
                    EXPECT_FALSE(corner.x > hole.low_m.x + 1e-9 && corner.x < hole.high_m.x - 1e-9 &&
                                 corner.y > hole.low_m.y + 1e-9 && corner.y < hole.high_m.y - 1e-9);
        }
        EXPECT_NEAR(left + of_holes, area_of(gable), 1.0e-9);
    }
}

}  // namespace
}  // namespace quadrat::synthesis::houses
