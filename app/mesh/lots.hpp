// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::mesh {

// A piece of land to build on. Edge i goes from point i to the next.
struct Lot {
    std::vector<glm::dvec2> outline_m;  // simple, counter-clockwise
    std::vector<bool> is_street;        // of each edge
    int block = 0;

    double area_m2() const;
    double frontage_m() const;  // along streets, all of it
};

struct LotRules {
    double largest_m2 = 600;      // larger ones are split
    double smallest_m2 = 150;     // a split that leaves less is not made
    double least_frontage_m = 5;  // nor one that leaves less along the street: nobody is without access
    double irregularity = 0.15;   // 0 to 0.5: by how much of its length a split may miss the middle
};

// Splits a block along its longest axis, and what comes of that again (Parish & Müller 2001), crosswise where
// lengthwise would cut somebody off the street. All of the block's own edges are streets. Lots cover the block. A pure
// function.
std::vector<Lot> lots_of_block(const std::vector<glm::dvec2>& block, int number, const LotRules& rules,
                               base::Seed seed);

// A block's building land: the block without half the street's width along its edges. Several pieces where it is
// narrow.
std::vector<std::vector<glm::dvec2>> behind_streets(const std::vector<std::vector<glm::dvec2>>& block,
                                                    double half_street_m);

struct TownPlan {
    std::vector<std::vector<std::vector<glm::dvec2>>> blocks;  // outlines, holes after the outer one
    std::vector<Lot> lots;
};

struct TownRules {
    int sites = 24;       // of the Voronoi diagram, 1 to 2000
    double uneven = 0;    // 0 to 1: head starts, as a share of the sites' spacing
    double merged = 0.2;  // 0 to 1: the share of cells that are joined with a neighbour
    double street_m = 6;  // width
    LotRules lots;
};

// Figure 5 of Kelly's report: cells of points by chance within a region, a simple polygon either way round, some merged
// with a neighbour, then streets between them and lots. Where a bay cuts a cell in two, each part is a block. Throws
// PlanError where edges of the region all but touch; what crosses itself is the caller's to find, see plan_check.
TownPlan plan_town(const std::vector<glm::dvec2>& region, const TownRules& rules, base::Seed seed);

}  // namespace quadrat::mesh
