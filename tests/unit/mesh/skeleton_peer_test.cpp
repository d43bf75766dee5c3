// SPDX-License-Identifier: Apache-2.0
// Beside CGAL's straight skeleton, which knows no slopes: the same nodes at the same heights.
#include <gtest/gtest.h>

#ifdef QUADRAT_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <glm/geometric.hpp>

#include "support/effort.hpp"
#include "support/plans.hpp"

namespace quadrat::mesh {
namespace {

using namespace tests;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Outline = CGAL::Polygon_2<Kernel>;

std::vector<glm::dvec3> nodes_by_peer(const Plan& plan) {
    const auto outline = [](const Loop& loop) {
        Outline made;
        for (const glm::dvec2& p : loop) made.push_back({p.x, p.y});
        return made;
    };
    CGAL::Polygon_with_holes_2<Kernel> polygon(outline(plan.outer));
    for (const Loop& hole : plan.holes) {
        Outline made = outline(hole);
        made.reverse_orientation();
        polygon.add_hole(made);
    }
    const auto skeleton = CGAL::create_interior_straight_skeleton_2(polygon);
    std::vector<glm::dvec3> nodes;
    for (auto v = skeleton->vertices_begin(); v != skeleton->vertices_end(); ++v)
        if (v->is_skeleton()) nodes.emplace_back(v->point().x(), v->point().y(), CGAL::to_double(v->time()));
    return nodes;
}

// How far the worse of two sets of nodes is from the other.
double distance(const std::vector<glm::dvec3>& ours, const std::vector<glm::dvec3>& theirs) {
    const auto from = [](const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
        double worst = 0;
        for (const glm::dvec3& p : a) {
            double nearest = 1.0e300;
            for (const glm::dvec3& q : b) nearest = std::min(nearest, glm::distance(p, q));
            worst = std::max(worst, nearest);
        }
        return worst;
    };
    return std::max(from(ours, theirs), from(theirs, ours));
}

TEST(StraightSkeleton, HasTheNodesOfCgalsOnTwoThousandPolygons) {
    double worst = 0;
    std::size_t nodes = 0;
    for (int i = 0; i < of(2000); ++i) {
        base::RandomStream chance{base::Seed{7}.child(static_cast<std::uint64_t>(i))};
        Plan plan;
        if (i % 4 == 0) {
            plan.outer = maze_loop(2 + static_cast<int>(chance.below(3)), 0.1, chance);
        } else {
            plan.outer = star_loop((i % 4 == 1 ? 8 : 3) + static_cast<int>(chance.below(24)), 5, 10, {0, 0}, chance);
        }
        if (i % 4 == 1) plan.holes = {star_loop(3 + static_cast<int>(chance.below(8)), 1, 3, {0, 0}, chance)};
        const Roof roof = straight_skeleton(plan);
        std::vector<glm::dvec3> inner;
        for (const glm::dvec3& v : roof.vertices)
            if (v.z > 0) inner.push_back(v);
        const std::vector<glm::dvec3> theirs = nodes_by_peer(plan);
        nodes += theirs.size();
        const double d = distance(inner, theirs);
        EXPECT_LT(d, 1e-6) << "polygon " << i << " of " << plan.edge_count();
        worst = std::max(worst, d);
    }
    RecordProperty("nodes", static_cast<int>(nodes));
    std::printf("%zu nodes, at most %.2g m apart\n", nodes, worst);
}

}  // namespace
}  // namespace quadrat::mesh
#else
TEST(StraightSkeleton, HasTheNodesOfCgalsOnTwoThousandPolygons) { GTEST_SKIP() << "libcgal-dev is missing"; }
#endif
