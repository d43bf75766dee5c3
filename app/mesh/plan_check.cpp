// SPDX-License-Identifier: Apache-2.0
#include "mesh/plan_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "mesh/exact_planes.hpp"

namespace quadrat::mesh {
namespace {

using Point = CheckedPlan::Point;
constexpr double kLargest = 0x1.0p50;  // of decimal fractions a number keeps fifteen places, and so do we
constexpr double kNearest = 1.0e-7;    // of the extent
constexpr std::size_t kMostPoints = 1U << 20U;

int orientation(Point a, Point b, Point c) {
    const Int128 area = static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
    return (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0);
}

Int128 twice_area(const std::vector<Point>& points) {
    Int128 area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& a = points[i];
        const Point& b = points[(i + 1) % points.size()];
        area += static_cast<Int128>(a.x) * b.y - static_cast<Int128>(b.x) * a.y;
    }
    return area;
}

glm::dvec2 number(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double distance_to_segment(Point p, Point a, Point b) {
    const glm::dvec2 along = number({b.x - a.x, b.y - a.y});
    const glm::dvec2 to = number({p.x - a.x, p.y - a.y});
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(to, along) / length2, 0.0, 1.0) : 0.0;
    return glm::length(to - t * along);
}

bool is_crossing(Point a, Point b, Point c, Point d) {
    return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

std::vector<std::vector<glm::dvec2>> loops_of(const Plan& plan) {
    std::vector<std::vector<glm::dvec2>> loops{plan.outer};
    loops.insert(loops.end(), plan.holes.begin(), plan.holes.end());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const std::string name = i == 0 ? "the outer loop" : fmt::format("hole {}", i - 1);
        if (loops[i].size() < 3)
            throw PlanError(fmt::format("{} has {} points; it needs three", name, loops[i].size()));
        for (std::size_t k = 0; k < loops[i].size(); ++k)
            if (!std::isfinite(loops[i][k].x) || !std::isfinite(loops[i][k].y) ||
                std::max(std::abs(loops[i][k].x), std::abs(loops[i][k].y)) > 1.0e9)
                throw PlanError(fmt::format("point {} of {} is no place: numbers to 1e9 m are", k, name));
    }
    return loops;
}

void place(CheckedPlan& checked, const std::vector<std::vector<glm::dvec2>>& loops) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const auto& loop : loops)
        for (const glm::dvec2& p : loop) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    checked.centre_m = glm::round(0.5 * (low + high));
    const double half = std::max({high.x - checked.centre_m.x, checked.centre_m.x - low.x, high.y - checked.centre_m.y,
                                  checked.centre_m.y - low.y});
    if (!(half > 1.0e-9)) throw PlanError("all of its points are in one place");
    while (checked.units_per_m * 10 * half < kLargest) checked.units_per_m *= 10;
    while (checked.units_per_m * half > kLargest) checked.units_per_m /= 10;
    checked.near_units = kNearest * 2 * half * checked.units_per_m;
}

Point whole(const CheckedPlan& checked, glm::dvec2 p) {
    const glm::dvec2 at = (p - checked.centre_m) * checked.units_per_m;
    return {std::llround(at.x), std::llround(at.y)};
}

// Each loop in its turning sense; an edge keeps its number.
void enter_loops(CheckedPlan& checked, const std::vector<std::vector<glm::dvec2>>& loops) {
    int first_edge = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto count = static_cast<int>(loops[l].size());
        std::vector<Point> points;
        for (const glm::dvec2& p : loops[l]) points.push_back(whole(checked, p));
        const Int128 area = twice_area(points);
        const bool is_reversed = (l == 0) != (area > 0);
        const auto first = static_cast<int>(checked.points.size());
        std::vector<int> loop;
        for (int i = 0; i < count; ++i) {
            const int from = is_reversed ? count - 1 - i : i;
            loop.push_back(first + i);
            checked.points.push_back(points[static_cast<std::size_t>(from)]);
            checked.given.push_back(loops[l][static_cast<std::size_t>(from)]);
            checked.next.push_back(first + (i + 1) % count);
            checked.edge.push_back(first_edge + (is_reversed ? (from + count - 1) % count : from));
        }
        checked.loops.push_back(loop);
        first_edge += count;
    }
}

struct Near {
    const CheckedPlan& plan;
    Point start(int i) const { return plan.points[static_cast<std::size_t>(i)]; }
    int next(int i) const { return plan.next[static_cast<std::size_t>(i)]; }
    int edge(int i) const { return plan.edge[static_cast<std::size_t>(i)]; }
    double metres(double units) const { return units / plan.units_per_m; }

    void check_pair(int i, int j) const {
        const Point a = start(i);
        const Point b = start(next(i));
        const Point c = start(j);
        const Point d = start(next(j));
        double nearest = 0;
        if (next(i) == j || next(j) == i) {
            nearest = next(i) == j ? std::min(distance_to_segment(a, c, d), distance_to_segment(d, a, b))
                                   : std::min(distance_to_segment(c, a, b), distance_to_segment(b, c, d));
            if (next(i) == j && next(j) == i) nearest = 0;
            if (nearest < plan.near_units)
                throw PlanError(fmt::format("edges {} and {} fold back on each other", std::min(edge(i), edge(j)),
                                            std::max(edge(i), edge(j))));
            return;
        }
        const char* how = "cross";
        if (!is_crossing(a, b, c, d)) {
            nearest = std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                                distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
            if (nearest >= plan.near_units) return;
            how = "touch";
        }
        throw PlanError(fmt::format("edges {} and {} {}", std::min(edge(i), edge(j)), std::max(edge(i), edge(j)), how));
    }

    void check_length(int i) const {
        const double length = glm::length(number(start(next(i))) - number(start(i)));
        if (length < plan.near_units)
            throw PlanError(fmt::format("edge {} is {:.2g} m long; of this extent it needs {:.2g} m", edge(i),
                                        metres(length), metres(plan.near_units)));
    }
};

// Every pair whose boxes come near, from left to right.
void check_pairs(const CheckedPlan& checked) {
    const Near near{checked};
    const auto count = static_cast<int>(checked.points.size());
    std::vector<int> order(checked.points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto low = [&](int i) { return std::min(near.start(i).x, near.start(near.next(i)).x); };
    const auto high = [&](int i) { return std::max(near.start(i).x, near.start(near.next(i)).x); };
    const auto bottom = [&](int i) { return std::min(near.start(i).y, near.start(near.next(i)).y); };
    const auto top = [&](int i) { return std::max(near.start(i).y, near.start(near.next(i)).y); };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return low(i) != low(j) ? low(i) < low(j) : i < j; });
    for (int i = 0; i < count; ++i) near.check_length(i);
    const auto margin = static_cast<std::int64_t>(checked.near_units) + 1;
    std::vector<int> open;
    for (const int i : order) {
        std::erase_if(open, [&](int j) { return high(j) + margin < low(i); });
        for (const int j : open)
            if (bottom(i) <= top(j) + margin && bottom(j) <= top(i) + margin) near.check_pair(j, i);
        open.push_back(i);
    }
}

bool is_inside(const CheckedPlan& checked, const std::vector<int>& loop, Point p) {
    bool is_in = false;
    for (const int i : loop) {
        const Point a = checked.points[static_cast<std::size_t>(i)];
        const Point b = checked.points[static_cast<std::size_t>(checked.next[static_cast<std::size_t>(i)])];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (orientation(a, b, p) * (b.y > a.y ? 1 : -1) > 0) is_in = !is_in;
    }
    return is_in;
}

void check_holes(const CheckedPlan& checked) {
    for (std::size_t h = 1; h < checked.loops.size(); ++h) {
        const Point p = checked.points[static_cast<std::size_t>(checked.loops[h].front())];
        if (!is_inside(checked, checked.loops[0], p)) throw PlanError(fmt::format("hole {} is outside", h - 1));
        for (std::size_t other = 1; other < checked.loops.size(); ++other)
            if (other != h && is_inside(checked, checked.loops[other], p))
                throw PlanError(fmt::format("hole {} is inside of hole {}", h - 1, other - 1));
    }
}

}  // namespace

std::size_t Plan::edge_count() const {
    std::size_t count = outer.size();
    for (const auto& hole : holes) count += hole.size();
    return count;
}

CheckedPlan checked(const Plan& plan) {
    if (plan.edge_count() > kMostPoints)
        throw PlanError(fmt::format("{} points; at most {} can be roofed", plan.edge_count(), kMostPoints));
    const auto loops = loops_of(plan);
    CheckedPlan checked;
    place(checked, loops);
    enter_loops(checked, loops);
    check_pairs(checked);
    check_holes(checked);
    return checked;
}

}  // namespace quadrat::mesh
