// SPDX-License-Identifier: Apache-2.0
#include "mesh/lots.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "mesh/straight_skeleton.hpp"
#include "mesh/voronoi.hpp"
#include "support/plans.hpp"

namespace quadrat::mesh {
namespace {

using namespace tests;

const Loop kRegion{{0, 0}, {300, 20}, {320, 200}, {140, 280}, {-20, 160}};

std::vector<VoronoiSite> sites_of(int count, double head_start_m, base::Seed seed) {
    base::RandomStream chance{seed};
    std::vector<VoronoiSite> sites;
    for (int i = 0; i < count; ++i)
        sites.push_back({{300 * chance.unit(), 250 * chance.unit()}, head_start_m * chance.unit()});
    return sites;
}

Loop points_of(const std::vector<VoronoiSite>& sites, const VoronoiCell& cell, int site) {
    Loop loop;
    for (const VoronoiArc& arc : cell.arcs) {
        const Loop points = arc_points(sites, site, arc, 1e-4);
        loop.insert(loop.end(), points.begin(), points.end());
    }
    return loop;
}

int first_to_reach(const std::vector<VoronoiSite>& sites, glm::dvec2 p) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const double d = glm::distance(p, sites[i].at_m) - sites[i].head_start_m;
        if (d >= least) continue;
        least = d;
        best = static_cast<int>(i);
    }
    return best;
}

bool is_in(const Loop& loop, glm::dvec2 p) {
    bool is_inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = loop[i];
        const glm::dvec2 b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
}

TEST(Voronoi, GivesEveryPointToTheSiteThatReachesItFirst) {
    for (const double head_start_m : {0.0, 30.0}) {
        for (std::uint64_t run = 0; run < 20; ++run) {
            const auto sites = sites_of(40, head_start_m, base::Seed{11}.child(run));
            const auto cells = voronoi_cells(sites, kRegion);
            double area = 0;
            std::vector<Loop> outlines;
            for (std::size_t i = 0; i < cells.size(); ++i) {
                outlines.push_back(points_of(sites, cells[i], static_cast<int>(i)));
                area += signed_area(outlines.back());
            }
            base::RandomStream chance{base::Seed{12}.child(run)};
            int wrong = 0;
            for (int k = 0; k < 400; ++k) {
                const glm::dvec2 p(320 * chance.unit(), 280 * chance.unit());
                const int first = first_to_reach(sites, p);
                if (!is_in(kRegion, p) || !is_in(kRegion, sites[static_cast<std::size_t>(first)].at_m)) continue;
                wrong += is_in(outlines[static_cast<std::size_t>(first)], p) ? 0 : 1;
            }
            EXPECT_EQ(wrong, 0) << run << " with head starts to " << head_start_m;
            EXPECT_LE(area, signed_area(kRegion) * (1 + 1e-6));
        }
    }
}

TEST(Voronoi, CoversTheRegionWhereAllSitesAreInside) {
    std::vector<VoronoiSite> sites;
    for (const VoronoiSite& site : sites_of(60, 25, base::Seed{3}))
        if (is_in(kRegion, site.at_m)) sites.push_back(site);
    const auto cells = voronoi_cells(sites, kRegion);
    double area = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) area += signed_area(points_of(sites, cells[i], static_cast<int>(i)));
    EXPECT_NEAR(area / signed_area(kRegion), 1, 1e-5);
}

TEST(Voronoi, HasNoCellForWhatOthersHeadStartsCover) {
    const std::vector<VoronoiSite> sites{{{100, 100}, 50}, {{110, 100}, 0}, {{200, 100}, 0}, {{200, 100}, 0}};
    const auto cells = voronoi_cells(sites, kRegion);
    EXPECT_FALSE(cells[0].arcs.empty());
    EXPECT_TRUE(cells[1].arcs.empty());
    EXPECT_FALSE(cells[2].arcs.empty());
    EXPECT_TRUE(cells[3].arcs.empty());
}

TEST(Voronoi, JoinsCellsWithoutTheLineBetweenThem) {
    const std::vector<VoronoiSite> sites{{{80, 100}, 0}, {{160, 100}, 10}, {{240, 100}, 0}};
    const auto cells = voronoi_cells(sites, kRegion);
    const auto outline = merged_outline(sites, cells, {0, 1}, 1e-4);
    ASSERT_EQ(outline.size(), 1U);
    EXPECT_NEAR(signed_area(outline[0]),
                signed_area(points_of(sites, cells[0], 0)) + signed_area(points_of(sites, cells[1], 1)), 1e-2);
}

TEST(Lots, CoverTheirBlockAndLieAtAStreet) {
    for (std::uint64_t run = 0; run < 40; ++run) {
        TownRules rules;
        rules.uneven = run % 2 == 0 ? 0 : 0.8;
        const TownPlan town = plan_town(kRegion, rules, base::Seed{run});
        EXPECT_GT(town.blocks.size(), 8U);
        double land = 0;
        for (const auto& block : town.blocks)
            for (const Loop& piece : behind_streets(block, 0.5 * rules.street_m)) land += signed_area(piece);
        double lots = 0;
        for (const Lot& lot : town.lots) {
            lots += lot.area_m2();
            EXPECT_GT(lot.area_m2(), 0) << run;
            EXPECT_GE(lot.frontage_m(), rules.lots.least_frontage_m) << run;
        }
        EXPECT_NEAR(lots / land, 1, 1e-9) << run;
    }
}

TEST(Lots, StayWithinTheirSizesWhereAccessAllowsIt) {
    const Loop block = rectangle(0, 0, 120, 40);
    const LotRules rules;
    const std::vector<Lot> lots = lots_of_block(block, 0, rules, base::Seed{4});
    EXPECT_GE(lots.size(), 8U);
    for (const Lot& lot : lots) {
        EXPECT_LE(lot.area_m2(), rules.largest_m2);
        EXPECT_GE(lot.area_m2(), rules.smallest_m2);
    }
}

TEST(Lots, AreCutFromBlocksThatAreNotConvex) {
    const Loop u{{0, 0}, {90, 0}, {90, 70}, {60, 70}, {60, 25}, {30, 25}, {30, 70}, {0, 70}};
    double area = 0;
    for (const Lot& lot : lots_of_block(u, 0, {}, base::Seed{5})) area += lot.area_m2();
    EXPECT_NEAR(area, signed_area(u), 1e-6);
}

TEST(Lots, NeedARegionThatIsConvex) {
    EXPECT_THROW(plan_town({{0, 0}, {50, 50}, {100, 0}, {100, 100}, {0, 100}}, {}, base::Seed{1}), PlanError);
}

}  // namespace
}  // namespace quadrat::mesh
