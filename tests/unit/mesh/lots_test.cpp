// SPDX-License-Identifier: Apache-2.0
#include "mesh/lots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/clip.hpp"
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

// A bay, a comb, a spiral, a star.
const std::vector<Loop> kBent{
    {{0, 0}, {150, 120}, {300, 0}, {300, 240}, {0, 240}},
    {{0, 0},
     {400, 0},
     {400, 200},
     {340, 200},
     {330, 60},
     {270, 60},
     {260, 200},
     {140, 200},
     {130, 60},
     {70, 60},
     {60, 200},
     {0, 200}},
    {{0, 0},
     {300, 0},
     {300, 300},
     {60, 300},
     {60, 120},
     {200, 120},
     {200, 200},
     {120, 200},
     {120, 240},
     {240, 240},
     {240, 60},
     {0, 60}},
};

TEST(Lots, CoverARegionOfAnyShape) {
    base::RandomStream chance{base::Seed{3}};
    std::vector<Loop> regions = kBent;
    for (int k = 0; k < 10; ++k) regions.push_back(star_loop(9 + 3 * k, 60, 200, {0, 0}, chance));
    for (std::size_t r = 0; r < regions.size(); ++r)
        for (std::uint64_t run = 0; run < 6; ++run) {
            TownRules rules;
            rules.uneven = run % 2 == 0 ? 0 : 0.7;
            const TownPlan town = plan_town(regions[r], rules, base::Seed{run});
            double blocks = 0;
            for (const auto& block : town.blocks)
                for (const Loop& loop : block) blocks += signed_area(loop);
            // An arc's points from either side may leave it by a little.
            EXPECT_NEAR(blocks / signed_area(regions[r]), 1, rules.uneven > 0 ? 5e-3 : 1e-9) << r << ", " << run;
            for (const Lot& lot : town.lots) {
                EXPECT_GT(lot.area_m2(), 0) << r << ", " << run;
                for (const glm::dvec2 p : lot.outline_m) EXPECT_TRUE(is_in(regions[r], p)) << r << ", " << run;
            }
        }
}

TEST(Clip, AgreesWithCountingPoints) {
    for (std::uint64_t run = 0; run < 200; ++run) {
        base::RandomStream chance{base::Seed{77}.child(run)};
        const Loop a = star_loop(12, 3, 10, {0, 0}, chance);
        const Loop b = star_loop(15, 3, 10, {5, 2}, chance);
        const auto common = common_area({a}, {b});
        ASSERT_TRUE(common) << run;
        for (int k = 0; k < 300; ++k) {
            const glm::dvec2 p(20 * chance.unit() - 8, 20 * chance.unit() - 9);
            EXPECT_EQ(is_inside(*common, p), is_in(a, p) && is_in(b, p)) << run;
        }
    }
}

TEST(Clip, KeepsHolesAndParts) {
    Loop hole = rectangle(4.01, 4.02, 2, 2);
    std::reverse(hole.begin(), hole.end());
    const auto within = common_area({rectangle(0, 0, 10, 10), hole}, {rectangle(-1.03, -1.04, 20, 20)});
    ASSERT_TRUE(within);
    const auto shapes = sorted_into_shapes(*within);
    ASSERT_EQ(shapes.size(), 1U);
    EXPECT_EQ(shapes[0].size(), 2U);
    const Loop u{{0, 0}, {9, 0}, {9, 7}, {6, 7}, {6, 2}, {3, 2}, {3, 7}, {0, 7}};
    const auto apart = common_area({u}, {rectangle(-1.1, 3.3, 20, 2)});
    ASSERT_TRUE(apart);
    EXPECT_EQ(sorted_into_shapes(*apart).size(), 2U);
}

TEST(Clip, SaysWhereItCannotTell) {
    EXPECT_FALSE(common_area({rectangle(0, 0, 4, 4)}, {rectangle(2, 0, 4, 4)}));
    const auto none = common_area({rectangle(0, 0, 4, 4)}, {rectangle(10, 0, 4, 4)});
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->empty());
}

}  // namespace
}  // namespace quadrat::mesh
