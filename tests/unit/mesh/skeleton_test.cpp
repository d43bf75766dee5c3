// SPDX-License-Identifier: Apache-2.0
#include "mesh/straight_skeleton.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mesh/roof_mesh.hpp"
#include "support/effort.hpp"
#include "support/plans.hpp"

namespace quadrat::mesh {
namespace {

using namespace tests;
using testing::HasSubstr;

RoofOptions slopes(std::vector<double> degrees) {
    RoofOptions options;
    options.profiles.clear();
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        options.profiles.push_back({{{0, degrees[i]}}});
        options.profile_of_edge.push_back(static_cast<int>(i));
    }
    return options;
}

double highest(const Roof& roof) {
    double z = 0;
    for (const glm::dvec3& v : roof.vertices) z = std::max(z, v.z);
    return z;
}

// Under the roof, by prisms over its triangles.
double volume(const Roof& roof) {
    double sum = 0;
    const auto add = [&](const std::vector<std::uint32_t>& loop) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const glm::dvec3 a = roof.vertices[loop[0]];
            const glm::dvec3 b = roof.vertices[loop[i]];
            const glm::dvec3 c = roof.vertices[loop[i + 1]];
            sum += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2 * (a.z + b.z + c.z) / 3;
        }
    };
    for (const RoofFace& face : roof.faces) {
        add(face.outline);
        for (const auto& hole : face.holes) add(hole);
    }
    for (const auto& top : roof.tops) add(top);
    return sum;
}

double area_at(const Plan& plan, RoofOptions options, double height) {
    options.height_m = height;
    const Roof roof = straight_skeleton(plan, options);
    double area = 0;
    for (const auto& top : roof.tops) {
        Loop flat;
        for (const std::uint32_t v : top) flat.emplace_back(roof.vertices[v]);
        area += signed_area(flat);
    }
    return area;
}

TEST(StraightSkeleton, RoofsARectangleWithALevelRidge) {
    const Plan plan{rectangle(0, 0, 6, 2), {}};
    const Roof roof = straight_skeleton(plan);
    EXPECT_EQ(roof.vertices.size(), 6U);
    EXPECT_EQ(roof.faces.size(), 4U);
    EXPECT_DOUBLE_EQ(highest(roof), 1);
    EXPECT_NEAR(volume(roof), 2 * 2 * 1 / 3.0 + 4 * 2 * 1 / 2.0, 1e-12);
}

TEST(StraightSkeleton, HoldsOnTwoHundredDegeneratePlans) {
    const std::vector<NamedPlan> plans = degenerate_plans();
    EXPECT_GE(plans.size(), 200U);
    for (const auto& [name, plan] : plans) {
        const Roof roof = straight_skeleton(plan);
        EXPECT_EQ(fault_of(plan, {}, roof), "") << name;
        EXPECT_EQ(roof.faces.size(), plan.edge_count()) << name;
    }
}

TEST(StraightSkeleton, BringsManyEdgesToOnePoint) {
    for (const auto& [name, plan] : degenerate_plans()) {
        if (name.find("regular") != 0 && name.find("star") != 0) continue;
        EXPECT_EQ(straight_skeleton(plan).vertices.size(), plan.outer.size() + 1) << name;
    }
}

TEST(StraightSkeleton, HoldsOnPolygonsByChanceWithSlopesByChance) {
    for (int i = 0; i < of(1500); ++i) {
        base::RandomStream chance{base::Seed{1}.child(static_cast<std::uint64_t>(i))};
        Plan plan;
        if (i % 3 == 0) {
            plan.outer = maze_loop(2 + static_cast<int>(chance.below(5)), 0.1, chance);
        } else {
            plan.outer = star_loop((i % 3 == 1 ? 8 : 3) + static_cast<int>(chance.below(30)), 6, 10, {0, 0}, chance);
        }
        if (i % 3 == 1) plan.holes = {star_loop(3 + static_cast<int>(chance.below(9)), 1, 4, {0, 0}, chance)};
        std::vector<double> degrees;
        for (std::size_t k = 0; k < plan.edge_count(); ++k) degrees.push_back(15 + 70 * chance.unit());
        const RoofOptions options = slopes(degrees);
        const Roof roof = straight_skeleton(plan, options);
        EXPECT_EQ(fault_of(plan, options, roof), "") << i;
        EXPECT_EQ(roof.faces.size(), plan.edge_count()) << i;
    }
}

TEST(StraightSkeleton, HasTheVolumeThatItsSectionsSweep) {
    for (int i = 0; i < of(30); ++i) {
        base::RandomStream chance{base::Seed{2}.child(static_cast<std::uint64_t>(i))};
        const Plan plan{star_loop(3 + static_cast<int>(chance.below(12)), 5, 10, {0, 0}, chance), {}};
        std::vector<double> degrees;
        for (std::size_t k = 0; k < plan.edge_count(); ++k) degrees.push_back(30 + 40 * chance.unit());
        const RoofOptions options = slopes(degrees);
        const Roof roof = straight_skeleton(plan, options);
        constexpr int kSteps = 200;
        const double top = highest(roof);
        double swept = 0;  // by the middle of each layer
        for (int k = 0; k < kSteps; ++k) swept += area_at(plan, options, top * (k + 0.5) / kSteps) * top / kSteps;
        EXPECT_NEAR(swept / volume(roof), 1, 2e-4) << i;
    }
}

TEST(StraightSkeleton, PutsAGableWhereAnEdgeIsVertical) {
    const Plan plan{rectangle(0, 0, 6, 2), {}};
    const RoofOptions options = slopes({45, 90, 45, 90});
    const Roof roof = straight_skeleton(plan, options);
    EXPECT_EQ(fault_of(plan, options, roof), "");
    EXPECT_NEAR(volume(roof), 6 * 2 * 1 / 2.0, 1e-12);
}

TEST(StraightSkeleton, BuildsWallsEavesAndAMansard) {
    RoofOptions options;
    options.profiles = {{{{0, 90}, {3, 160}, {3.2, 70}, {5, 30}}}};
    for (const auto& [name, plan] : degenerate_plans()) {
        const Roof roof = straight_skeleton(plan, options);
        EXPECT_EQ(fault_of(plan, options, roof), "") << name;
    }
    EXPECT_EQ(straight_skeleton({rectangle(0, 0, 6, 5), {}}, options).faces.size(), 16U);
}

TEST(StraightSkeleton, CutsHalfHipsOffAGable) {
    RoofOptions options;
    options.profiles = {{{{0, 45}}}, {{{0, 90}, {1, 40}}}};
    options.profile_of_edge = {0, 1, 0, 1};
    const Plan plan{rectangle(0, 0, 8, 4), {}};
    const Roof roof = straight_skeleton(plan, options);
    EXPECT_EQ(fault_of(plan, options, roof), "");
    EXPECT_EQ(roof.faces.size(), 6U);
}

TEST(StraightSkeleton, EndsWhereItIsTold) {
    for (const auto& [name, plan] : degenerate_plans()) {
        RoofOptions options;
        options.height_m = 0.3;
        const Roof roof = straight_skeleton(plan, options);
        EXPECT_EQ(fault_of(plan, options, roof), "") << name;
        for (const auto& top : roof.tops)
            for (const std::uint32_t v : top) EXPECT_NEAR(roof.vertices[v].z, 0.3, 1e-6) << name;
    }
}

TEST(StraightSkeleton, LeansOutwardAsFarAsTheHeight) {
    const Plan u{{{0, 0}, {9, 0}, {9, 6}, {6, 6}, {6, 2}, {3, 2}, {3, 6}, {0, 6}}, {}};
    RoofOptions options;
    options.profiles = {{{{0, 120}}}};
    EXPECT_THROW(straight_skeleton(u, options), PlanError);
    for (const double height : {1.0, 2.5, 2.7, 6.0}) {
        options.height_m = height;
        const Roof roof = straight_skeleton(u, options);
        const double by = height / std::tan(std::numbers::pi / 3);
        double area = 0;
        for (const auto& top : roof.tops) {
            Loop flat;
            for (const std::uint32_t v : top) flat.emplace_back(roof.vertices[v]);
            area += signed_area(flat);
        }
        const double gap = std::max(0.0, 3 - 2 * by) * std::max(0.0, 4.0);
        EXPECT_NEAR(area, (9 + 2 * by) * (6 + 2 * by) - gap, 1e-4) << height;
    }
}

// The paper's figures 65 and 66: a bay whose sides meet its wall again.
TEST(StraightSkeleton, ResolvesABayWindowBothWays) {
    const Plan bay{{{0, 0}, {10, 0}, {10, 6}, {6, 6}, {5.5, 7}, {4.5, 7}, {4, 6}, {0, 6}}, {}};
    RoofOptions options = slopes({45, 45, 45, 60, 30, 60, 45, 45});
    const Roof least = straight_skeleton(bay, options);
    options.ambiguity = Ambiguity::MostVolume;
    const Roof most = straight_skeleton(bay, options);
    EXPECT_EQ(fault_of(bay, options, least), "");
    EXPECT_EQ(fault_of(bay, options, most), "");
    EXPECT_LT(volume(least) + 1, volume(most));
}

TEST(StraightSkeleton, IsTheSameHoweverALoopTurns) {
    Plan plan{{{0, 0}, {7, 0}, {7, 2}, {3, 2.5}, {3, 6}, {0, 6}}, {rectangle(0.5, 0.5, 1, 1)}};
    const double before = volume(straight_skeleton(plan));
    std::reverse(plan.outer.begin(), plan.outer.end());
    std::reverse(plan.holes[0].begin(), plan.holes[0].end());
    const Roof roof = straight_skeleton(plan);
    EXPECT_EQ(fault_of(plan, {}, roof), "");
    EXPECT_NEAR(volume(roof), before, 1e-12);
}

std::string complaint(const Plan& plan, const RoofOptions& options = {}) {
    try {
        straight_skeleton(plan, options);
    } catch (const PlanError& error) {
        return error.what();
    }
    return {};
}

TEST(StraightSkeleton, SaysWhatIsWrongWithAPlan) {
    EXPECT_THAT(complaint({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}), HasSubstr("edges 0 and 2 cross"));
    EXPECT_THAT(complaint({{{0, 0}, {2, 0}}, {}}), HasSubstr("2 points"));
    EXPECT_THAT(complaint({{{0, 0}, {2, 0}, {0, 0}, {0, 2}}, {}}), HasSubstr("edges 0 and 2 touch"));
    EXPECT_THAT(complaint({{{0, 0}, {2, 0}, {2, 0}, {0, 2}}, {}}), HasSubstr("edge 1 is 0"));
    EXPECT_THAT(complaint({rectangle(0, 0, 2, 2), {rectangle(3, 3, 1, 1)}}), HasSubstr("hole 0 is outside"));
    EXPECT_THAT(complaint({rectangle(0, 0, 9, 9), {rectangle(1, 1, 7, 7), rectangle(3, 3, 1, 1)}}),
                HasSubstr("hole 1 is inside of hole 0"));
    EXPECT_THAT(complaint({rectangle(0, 0, 9, 9), {rectangle(1, 1, 7, 8)}}), HasSubstr("touch"));
    EXPECT_THAT(complaint({rectangle(0, 0, 2, 2), {}}, slopes({90, 90, 90, 90})), HasSubstr("give a height"));
    EXPECT_THAT(complaint({rectangle(0, 0, 2, 2), {}}, slopes({0.5, 90, 90, 90})), HasSubstr("a slope of 0.5"));
    EXPECT_THAT(complaint({{{0, 0}, {std::nan(""), 0}, {1, 2}}, {}}), HasSubstr("point 1"));
}

TEST(StraightSkeleton, HoldsOnThousandsOfEdges) {
    const auto edges_roofed = [](int side) {
        base::RandomStream chance{base::Seed{5}};
        const Plan plan{maze_loop(side, 0.1, chance), {}};
        const Roof roof = straight_skeleton(plan);
        EXPECT_EQ(fault_of(plan, {}, roof), "");
        return plan.outer.size();
    };
    EXPECT_GT(edges_roofed(of(40)), 20U);
}

}  // namespace
}  // namespace quadrat::mesh
