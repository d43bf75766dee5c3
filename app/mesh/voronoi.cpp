// SPDX-License-Identifier: Apache-2.0
// Additively weighted Voronoi diagrams (Ash & Bolker 1986). Seen from a site all that bounds its cell, lines and
// branches of hyperbolas with their focus there, has 1 / r = a + b cos t + c sin t; the cell is the upper envelope of
// these. It is built arc by arc, nearest neighbours first. For the hundred cells of a town that is as quick as
// Fortune's sweep; what is ours is that lines, arcs and the region's edges are one kind.
#include "mesh/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

namespace quadrat::mesh {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// 1 / r = a + b cos t + c sin t; where that is not positive nothing is met.
struct Bound {
    double a = 0, b = 0, c = 0;
    int neighbour = -1;
    double at(double t) const { return a + b * std::cos(t) + c * std::sin(t); }
};

struct Piece {
    double from, to;
    int bound;
};

Bound towards(const VoronoiSite& site, const VoronoiSite& other, int neighbour) {
    const glm::dvec2 d = other.at_m - site.at_m;
    const double k = other.head_start_m - site.head_start_m;
    const double power = glm::dot(d, d) - k * k;
    return {2 * k / power, 2 * d.x / power, 2 * d.y / power, neighbour};
}

bool is_covered(const VoronoiSite& site, std::size_t i, const std::vector<VoronoiSite>& sites) {
    for (std::size_t j = 0; j < sites.size(); ++j) {
        if (j == i) continue;
        const double ahead = sites[j].head_start_m - site.head_start_m;
        const double d = glm::distance(site.at_m, sites[j].at_m);
        if (d < ahead || (d == ahead && (d > 0 || j < i))) return true;
    }
    return false;
}

// Directions within (from, to) where the two bounds are equally far.
std::vector<double> crossings(const Bound& p, const Bound& q, double from, double to) {
    const double a = p.a - q.a;
    const double b = p.b - q.b;
    const double c = p.c - q.c;
    const double most = std::hypot(b, c);
    if (!(most > std::abs(a))) return {};
    const double middle = std::atan2(c, b);
    const double half = std::acos(-a / most);
    std::vector<double> found;
    for (double t : {middle - half, middle + half}) {
        t -= kTurn * std::floor((t - from) / kTurn);
        if (t > from && t < to) found.push_back(t);
    }
    std::sort(found.begin(), found.end());
    return found;
}

void insert(std::vector<Piece>& envelope, const std::vector<Bound>& bounds, int added) {
    const Bound& bound = bounds[static_cast<std::size_t>(added)];
    std::vector<Piece> next;
    const auto append = [&next](Piece piece) {
        if (!(piece.to > piece.from)) return;
        if (!next.empty() && next.back().bound == piece.bound) {
            next.back().to = piece.to;
        } else {
            next.push_back(piece);
        }
    };
    for (const Piece& piece : envelope) {
        const Bound& old = bounds[static_cast<std::size_t>(piece.bound)];
        double from = piece.from;
        std::vector<double> ends = crossings(bound, old, piece.from, piece.to);
        ends.push_back(piece.to);
        for (const double to : ends) {
            const double middle = 0.5 * (from + to);
            append({from, to, bound.at(middle) > old.at(middle) ? added : piece.bound});
            from = to;
        }
    }
    envelope = std::move(next);
}

glm::dvec2 point_at(const VoronoiSite& site, const Bound& bound, double t) {
    return site.at_m + glm::dvec2(std::cos(t), std::sin(t)) / bound.at(t);
}

VoronoiCell cell_of(const std::vector<VoronoiSite>& sites, std::size_t i, const std::vector<glm::dvec2>& region) {
    const VoronoiSite& site = sites[i];
    std::vector<Bound> bounds;
    for (std::size_t e = 0; e < region.size(); ++e) {
        const glm::dvec2 a = region[e];
        const glm::dvec2 along = glm::normalize(region[(e + 1) % region.size()] - a);
        const glm::dvec2 out(along.y, -along.x);
        const double distance = glm::dot(out, a - site.at_m);
        if (!(distance > 0)) return {};
        bounds.push_back({0, out.x / distance, out.y / distance, -1 - static_cast<int>(e)});
    }
    if (is_covered(site, i, sites)) return {};
    std::vector<Piece> envelope{{0, kTurn, 0}};
    for (std::size_t e = 1; e < region.size(); ++e) insert(envelope, bounds, static_cast<int>(e));
    std::vector<std::size_t> order;
    for (std::size_t j = 0; j < sites.size(); ++j)
        if (j != i && !is_covered(sites[j], j, sites)) order.push_back(j);
    std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
        const double to_p = glm::distance(site.at_m, sites[p].at_m) - sites[p].head_start_m;
        const double to_q = glm::distance(site.at_m, sites[q].at_m) - sites[q].head_start_m;
        return to_p != to_q ? to_p < to_q : p < q;
    });
    for (const std::size_t j : order) {
        bounds.push_back(towards(site, sites[j], static_cast<int>(j)));
        insert(envelope, bounds, static_cast<int>(bounds.size()) - 1);
    }
    // The direction 0 is no corner.
    if (envelope.size() > 1 && envelope.front().bound == envelope.back().bound) {
        envelope.front().from = envelope.back().from - kTurn;
        envelope.pop_back();
    }
    VoronoiCell cell;
    for (const Piece& piece : envelope) {
        const Bound& bound = bounds[static_cast<std::size_t>(piece.bound)];
        cell.arcs.push_back({bound.neighbour, point_at(site, bound, piece.from), point_at(site, bound, piece.to),
                             piece.from, piece.to});
    }
    return cell;
}

}  // namespace

std::vector<VoronoiCell> voronoi_cells(const std::vector<VoronoiSite>& sites, const std::vector<glm::dvec2>& region) {
    std::vector<VoronoiCell> cells(sites.size());
    if (region.size() < 3) return cells;
    for (std::size_t i = 0; i < sites.size(); ++i) cells[i] = cell_of(sites, i, region);
    return cells;
}

std::vector<glm::dvec2> arc_points(const std::vector<VoronoiSite>& sites, int site, const VoronoiArc& arc,
                                   double tolerance_m) {
    std::vector<glm::dvec2> points{arc.from_m};
    const VoronoiSite& from = sites[static_cast<std::size_t>(site)];
    if (arc.neighbour < 0) return points;
    const VoronoiSite& other = sites[static_cast<std::size_t>(arc.neighbour)];
    if (from.head_start_m == other.head_start_m) return points;
    const Bound bound = towards(from, other, arc.neighbour);
    int steps = 1;
    constexpr int kMostSteps = 256;
    for (; steps < kMostSteps; steps *= 2) {
        const double step = (arc.to_rad - arc.from_rad) / steps;
        double worst = 0;
        for (int s = 0; s < steps; ++s) {
            const double t = arc.from_rad + s * step;
            const glm::dvec2 a = point_at(from, bound, t);
            const glm::dvec2 b = point_at(from, bound, t + step);
            const glm::dvec2 m = point_at(from, bound, t + 0.5 * step);
            const glm::dvec2 along = (b - a) / std::max(glm::distance(a, b), 1.0e-300);
            worst = std::max(worst, std::abs(along.x * (m - a).y - along.y * (m - a).x));
        }
        if (worst <= tolerance_m) break;
    }
    for (int s = 1; s < steps; ++s)
        points.push_back(point_at(from, bound, arc.from_rad + (arc.to_rad - arc.from_rad) * s / steps));
    return points;
}

std::vector<std::vector<glm::dvec2>> merged_outline(const std::vector<VoronoiSite>& sites,
                                                    const std::vector<VoronoiCell>& cells,
                                                    const std::vector<int>& group, double tolerance_m) {
    struct Side {
        int site;
        const VoronoiArc* arc;
        bool is_taken = false;
    };
    std::vector<Side> sides;
    for (const int site : group)
        for (const VoronoiArc& arc : cells[static_cast<std::size_t>(site)].arcs)
            if (std::find(group.begin(), group.end(), arc.neighbour) == group.end()) sides.push_back({site, &arc});
    std::vector<std::vector<glm::dvec2>> outline;
    for (Side& first : sides) {
        if (first.is_taken) continue;
        std::vector<glm::dvec2> loop;
        Side* side = &first;
        const glm::dvec2 start = first.arc->from_m;
        while (side != nullptr) {
            side->is_taken = true;
            const std::vector<glm::dvec2> points = arc_points(sites, side->site, *side->arc, tolerance_m);
            loop.insert(loop.end(), points.begin(), points.end());
            const glm::dvec2 end = side->arc->to_m;
            double nearest = glm::distance(end, start);
            side = nullptr;
            for (Side& other : sides) {
                const double d = glm::distance(end, other.arc->from_m);
                if (other.is_taken || d >= nearest) continue;
                nearest = d;
                side = &other;
            }
        }
        if (loop.size() > 2) outline.push_back(std::move(loop));
    }
    return outline;
}

}  // namespace quadrat::mesh
