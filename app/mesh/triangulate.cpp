// SPDX-License-Identifier: Apache-2.0
// Monotone polygons: Garey, Johnson, Preparata & Tarjan 1978. Others: ears (Meisters 1975), with holes bridged to the
// outline from their rightmost point (Eberly 2002).
#include "mesh/triangulate.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

namespace quadrat::mesh {
namespace {

using Loop = std::vector<std::uint32_t>;
using Points = std::vector<glm::dvec2>;

constexpr double kTouch = 1.0e-9;

double area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

std::size_t leftmost(const Points& points, const Loop& loop) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        const glm::dvec2 p = points[loop[i]];
        const glm::dvec2 best = points[loop[first]];
        if (p.x < best.x || (p.x == best.x && p.y < best.y)) first = i;
    }
    return first;
}

bool goes_on(glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

struct Corner {
    std::uint32_t point;
    bool is_lower;
};

// Left to right, both chains together.
std::vector<Corner> sorted_corners(const Points& points, const Loop& loop) {
    const std::size_t count = loop.size();
    const std::size_t first = leftmost(points, loop);
    std::size_t last = 0;
    while (last + 1 < count && goes_on(points[loop[(first + last) % count]], points[loop[(first + last + 1) % count]]))
        ++last;
    std::vector<Corner> lower;
    std::vector<Corner> upper;
    for (std::size_t i = 0; i <= last; ++i) lower.push_back({loop[(first + i) % count], true});
    for (std::size_t i = count - 1; i > last; --i) upper.push_back({loop[(first + i) % count], false});
    std::vector<Corner> corners;
    std::merge(lower.begin(), lower.end(), upper.begin(), upper.end(), std::back_inserter(corners),
               [&points](const Corner& a, const Corner& b) { return goes_on(points[a.point], points[b.point]); });
    return corners;
}

class Triangles {
  public:
    explicit Triangles(const Points& points) : points_(points) {}
    bool add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (!(area(points_[a], points_[b], points_[c]) > 0)) return false;
        indices.insert(indices.end(), {a, b, c});
        return true;
    }
    std::vector<std::uint32_t> indices;

  private:
    const Points& points_;
};

void fan(Triangles& triangles, std::vector<Corner>& stack, const Corner& corner) {
    for (std::size_t i = 0; i + 1 < stack.size(); ++i) {
        if (stack.back().is_lower) {
            triangles.add(stack[i].point, stack[i + 1].point, corner.point);
        } else {
            triangles.add(stack[i + 1].point, stack[i].point, corner.point);
        }
    }
    stack = {stack.back(), corner};
}

std::vector<std::uint32_t> monotone_triangles(const Points& points, const Loop& loop) {
    const std::vector<Corner> corners = sorted_corners(points, loop);
    Triangles triangles(points);
    std::vector<Corner> stack{corners[0], corners[1]};
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Corner& corner = corners[i];
        if (i + 1 == corners.size() || corner.is_lower != stack.back().is_lower) {
            fan(triangles, stack, corner);
            continue;
        }
        while (stack.size() > 1) {
            const std::uint32_t a = stack[stack.size() - 2].point;
            const std::uint32_t b = stack.back().point;
            const bool is_cut = corner.is_lower ? triangles.add(a, b, corner.point) : triangles.add(b, a, corner.point);
            if (!is_cut) break;
            stack.pop_back();
        }
        stack.push_back(corner);
    }
    return std::move(triangles.indices);
}

bool sees(const Points& points, const Loop& loop, std::size_t at, glm::dvec2 from) {
    const glm::dvec2 to = points[loop[at]];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = points[loop[i]];
        const glm::dvec2 b = points[loop[(i + 1) % loop.size()]];
        if (a == to || b == to || a == from || b == from) continue;
        if (area(from, to, a) * area(from, to, b) < 0 && area(a, b, from) * area(a, b, to) < 0) return false;
    }
    return true;
}

void bridge(const Points& points, Loop& loop, const Loop& hole) {
    std::size_t start = 0;
    for (std::size_t i = 1; i < hole.size(); ++i)
        if (points[hole[i]].x > points[hole[start]].x) start = i;
    const glm::dvec2 from = points[hole[start]];
    std::size_t best = loop.size();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 p = points[loop[i]];
        const double distance = glm::dot(p - from, p - from);
        if (p.x < from.x || distance >= nearest || !sees(points, loop, i, from)) continue;
        best = i;
        nearest = distance;
    }
    if (best == loop.size()) return;
    Loop joined(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    for (std::size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(start + i) % hole.size()]);
    joined.insert(joined.end(), loop.begin() + static_cast<std::ptrdiff_t>(best), loop.end());
    loop = std::move(joined);
}

// Within is what lies deeper than a margin, a share of the ear's own area; below 0: also what touches.
bool is_ear(const Points& points, const Loop& loop, std::size_t at, double margin) {
    const std::size_t count = loop.size();
    const glm::dvec2 a = points[loop[(at + count - 1) % count]];
    const glm::dvec2 b = points[loop[at]];
    const glm::dvec2 c = points[loop[(at + 1) % count]];
    const double whole = area(a, b, c);
    if (!(whole > 0)) return false;
    for (const std::uint32_t other : loop) {
        const glm::dvec2 p = points[other];
        if (p == a || p == b || p == c) continue;
        const double least = margin * whole;
        if (area(a, b, p) > least && area(b, c, p) > least && area(c, a, p) > least) return false;
    }
    return true;
}

std::vector<std::uint32_t> ear_triangles(const Points& points, Loop loop) {
    Triangles triangles(points);
    while (loop.size() > 2) {
        std::size_t at = 0;
        while (at < loop.size() && !is_ear(points, loop, at, -kTouch)) ++at;
        if (at == loop.size()) at = 0;
        while (at < loop.size() && !is_ear(points, loop, at, kTouch)) ++at;
        if (at == loop.size()) {  // only rounding is left: take the corner that turns least wrongly
            at = 0;
            double best = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const double turn = area(points[loop[(i + loop.size() - 1) % loop.size()]], points[loop[i]],
                                         points[loop[(i + 1) % loop.size()]]);
                if (turn <= 0 && turn > best) {
                    best = turn;
                    at = i;
                }
            }
        }
        triangles.add(loop[(at + loop.size() - 1) % loop.size()], loop[at], loop[(at + 1) % loop.size()]);
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return std::move(triangles.indices);
}

}  // namespace

bool is_monotone(const Points& points, const Loop& outline) {
    int turns = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = points[outline[i]];
        const glm::dvec2 b = points[outline[(i + 1) % outline.size()]];
        const glm::dvec2 c = points[outline[(i + 2) % outline.size()]];
        turns += goes_on(a, b) != goes_on(b, c) ? 1 : 0;
    }
    return turns == 2;
}

std::vector<std::uint32_t> triangulate(const Points& points, const Loop& outline, const std::vector<Loop>& holes) {
    if (outline.size() < 3) return {};
    if (holes.empty() && is_monotone(points, outline)) return monotone_triangles(points, outline);
    Loop loop = outline;
    std::vector<Loop> from_right = holes;
    const auto reach = [&points](const Loop& hole) {
        double most = -std::numeric_limits<double>::infinity();
        for (const std::uint32_t p : hole) most = std::max(most, points[p].x);
        return most;
    };
    std::stable_sort(from_right.begin(), from_right.end(),
                     [&](const Loop& a, const Loop& b) { return reach(a) > reach(b); });
    for (const Loop& hole : from_right) bridge(points, loop, hole);
    return ear_triangles(points, std::move(loop));
}

}  // namespace quadrat::mesh
