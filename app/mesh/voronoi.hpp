// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::mesh {

// Where something begins to grow. Head start: how far it has come when the others begin, metres; 0 for all: the plain
// diagram.
struct VoronoiSite {
    glm::dvec2 at_m{0};
    double head_start_m = 0;
};

// A part of a cell's boundary, counter-clockwise: towards another site a straight line, or a branch of a hyperbola
// where their head starts differ; towards the region's edge a line.
struct VoronoiArc {
    int neighbour = -1;  // a site; -1 - edge where the region ends
    glm::dvec2 from_m{0}, to_m{0};
    double from_rad = 0, to_rad = 0;  // directions seen from the site; to_rad is the larger
};

struct VoronoiCell {
    std::vector<VoronoiArc> arcs;  // none where others' head starts cover the site itself
};

// The cells of sites within a convex region, counter-clockwise. Every point of the region belongs to the site that
// reaches it first: with the least distance minus head start. Sites outside the region, and those that share a place
// with an earlier one of as much head start, have no cell. Any order of sites gives the same cells.
std::vector<VoronoiCell> voronoi_cells(const std::vector<VoronoiSite>& sites, const std::vector<glm::dvec2>& region);

// The arc as a line of points, its end left out; an arc of a hyperbola leaves them by no more than the tolerance.
std::vector<glm::dvec2> arc_points(const std::vector<VoronoiSite>& sites, int site, const VoronoiArc& arc,
                                   double tolerance_m);

// The outline of several cells together, lines between them dropped: the paper's figure 5. Holes clockwise.
std::vector<std::vector<glm::dvec2>> merged_outline(const std::vector<VoronoiSite>& sites,
                                                    const std::vector<VoronoiCell>& cells,
                                                    const std::vector<int>& group, double tolerance_m);

}  // namespace quadrat::mesh
