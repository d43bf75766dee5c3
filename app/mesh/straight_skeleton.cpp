// SPDX-License-Identifier: Apache-2.0
// The weighted straight skeleton by a wavefront that shrinks: Aichholzer & Aurenhammer 1996; events as in Felkel &
// Obdrzalek 1998, with weights as in Eppstein & Erickson 1999; the chains of many edges that meet in one point, level
// ridges, profiles and both resolutions of parallel edges after Kelly & Wonka 2011 and Kelly's report (2008, chapter
// 5). What is ours: planes in fixed point with exact predicates in place of his clusters in space and height;
// directions and lines that are one but for rounding are made one before we begin, as the definition rests on that
// (his 5.1.8).
#include "mesh/straight_skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "mesh/exact_planes.hpp"
#include "mesh/plan_check.hpp"
#include "mesh/skeleton_faces.hpp"
#include "mesh/wavefront.hpp"

namespace quadrat::mesh {
namespace {

constexpr double kSameDirection = 1.0e-8;  // rad
constexpr double kUnitsPerScaled = 0x1.0p44;
constexpr double kHighestOffset = 0x1.0p60;

struct Direction {
    std::int64_t x = 0, y = 0;  // of the normal
};

// Of every edge, those that are parallel but for rounding with the same numbers or their negatives: the longest one's.
std::vector<Direction> directions_of(const CheckedPlan& plan) {
    const std::size_t count = plan.points.size();
    std::vector<glm::dvec2> along(count);
    std::vector<double> angle(count);  // in [0, 2), rises with the direction taken without its sign
    for (std::size_t i = 0; i < count; ++i) {
        const auto& a = plan.points[i];
        const auto& b = plan.points[static_cast<std::size_t>(plan.next[i])];
        along[i] = {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)};
        const glm::dvec2 d = along[i].y < 0 || (along[i].y == 0 && along[i].x < 0) ? -along[i] : along[i];
        const double share = d.x / (std::abs(d.x) + d.y);
        angle[i] = 1 - share;
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return angle[i] != angle[j] ? angle[i] < angle[j] : i < j; });
    const auto unit = [&](std::size_t i) { return along[i] / glm::length(along[i]); };
    const auto is_near = [&](std::size_t i, std::size_t j) {
        const glm::dvec2 a = unit(i);
        const glm::dvec2 b = unit(j);
        return std::abs(a.x * b.y - a.y * b.x) < kSameDirection;
    };
    std::size_t first = 0;  // begin where a gap is, as angles go round
    while (first + 1 < count && is_near(order[first], order[(first + count - 1) % count])) ++first;
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
    std::vector<Direction> directions(count);
    for (std::size_t begin = 0; begin < count;) {
        std::size_t end = begin + 1;
        while (end < count && is_near(order[end - 1], order[end]) && is_near(order[begin], order[end])) ++end;
        std::size_t longest = order[begin];
        for (std::size_t k = begin; k < end; ++k)
            if (glm::length(along[order[k]]) > glm::length(along[longest])) longest = order[k];
        const glm::dvec2 u = unit(longest);
        const Direction normal{std::llround(-u.y * 0x1.0p50), std::llround(u.x * 0x1.0p50)};
        for (std::size_t k = begin; k < end; ++k) {
            const bool is_opposite = glm::dot(along[order[k]], u) < 0;
            directions[order[k]] = is_opposite ? Direction{-normal.x, -normal.y} : normal;
        }
        begin = end;
    }
    return directions;
}

std::int64_t offset_of(const CheckedPlan& plan, std::size_t i, Direction normal) {
    const auto& a = plan.points[i];
    const auto& b = plan.points[static_cast<std::size_t>(plan.next[i])];
    const Int128 twice = static_cast<Int128>(normal.x) * (a.x + b.x) + static_cast<Int128>(normal.y) * (a.y + b.y);
    const Int128 half = static_cast<Int128>(1) << 44;  // a point's unit is 64 of an offset's
    return static_cast<std::int64_t>((twice + half) >> 45);
}

// Lines of one direction that lie in one another but for rounding get one offset.
std::vector<std::int64_t> offsets_of(const CheckedPlan& plan, const std::vector<Direction>& normals) {
    const std::size_t count = normals.size();
    std::vector<std::int64_t> offsets(count);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i < count; ++i) offsets[i] = offset_of(plan, i, normals[i]);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        if (normals[i].x != normals[j].x) return normals[i].x < normals[j].x;
        if (normals[i].y != normals[j].y) return normals[i].y < normals[j].y;
        return offsets[i] != offsets[j] ? offsets[i] < offsets[j] : i < j;
    });
    const auto reach = static_cast<std::int64_t>(64 * 0.05 * plan.near_units);
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t i = order[k];
        const std::size_t before = order[k - 1];
        if (normals[i].x == normals[before].x && normals[i].y == normals[before].y &&
            offsets[i] - offsets[before] < reach)
            offsets[i] = offsets[before];
    }
    return offsets;
}

std::int64_t speed_of(double slope_deg) {
    if (!(slope_deg >= 1 && slope_deg <= 179))
        throw PlanError(fmt::format("a slope of {} degrees; 1 to 179 can be built", slope_deg));
    const double angle = slope_deg * std::numbers::pi / 180;
    return std::llround(std::cos(angle) / std::sin(angle) * 0x1.0p28);
}

struct Change {
    std::int64_t height;
    int from, to;
};

class Builder {
  public:
    Builder(const CheckedPlan& plan, const RoofOptions& options) : plan_(plan), options_(options) {
        metres_per_scaled_ = kUnitsPerScaled / plan.units_per_m;
        check();
        add_planes();
    }

    Roof roof() {
        check_corners();
        start_.loops = plan_.loops;
        for (const auto& p : plan_.points)
            start_.points.emplace_back(static_cast<double>(p.x) / kUnitsPerScaled,
                                       static_cast<double>(p.y) / kUnitsPerScaled);
        start_.ambiguity = options_.ambiguity;
        Wavefront front(std::move(start_));
        run(front);
        return roof_from({plan_, front, owners_, metres_per_scaled_});
    }

  private:
    std::int64_t scaled_height(double metres) const {
        const double scaled = metres / metres_per_scaled_ / kHeightUnit;
        if (!(std::abs(scaled) < 0x1.0p40))
            throw PlanError(fmt::format("a height of {} m is beyond this plan", metres));
        return std::llround(scaled);
    }

    void check() const {
        if (options_.profiles.empty()) throw PlanError("there is no profile");
        if (!options_.profile_of_edge.empty() && options_.profile_of_edge.size() != plan_.points.size())
            throw PlanError(
                fmt::format("{} edges, but profiles for {}", plan_.points.size(), options_.profile_of_edge.size()));
        for (const int of : options_.profile_of_edge)
            if (of < 0 || static_cast<std::size_t>(of) >= options_.profiles.size())
                throw PlanError(fmt::format("there is no profile {}", of));
        for (const Profile& profile : options_.profiles) {
            if (profile.courses.empty() || profile.courses.front().from_m != 0)
                throw PlanError("a profile's first course begins at the height 0");
            for (std::size_t i = 1; i < profile.courses.size(); ++i)
                if (!(profile.courses[i].from_m > profile.courses[i - 1].from_m))
                    throw PlanError("a profile's courses stand in rising order");
        }
        if (options_.height_m && !(*options_.height_m > 0)) throw PlanError("the height where it ends is above 0");
    }

    int profile_of(std::size_t point) const {
        if (options_.profile_of_edge.empty()) return 0;
        return options_.profile_of_edge[static_cast<std::size_t>(plan_.edge[point])];
    }

    void add_planes() {
        const std::vector<Direction> normals = directions_of(plan_);
        const std::vector<std::int64_t> offsets = offsets_of(plan_, normals);
        const std::size_t count = normals.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto profile = static_cast<std::size_t>(profile_of(i));
            add_plane(moving_line(normals[i].x, normals[i].y, offsets[i],
                                  speed_of(options_.profiles[profile].courses.front().slope_deg)),
                      i, 0);
        }
        for (std::size_t i = 0; i < count; ++i) add_courses(i);
        std::stable_sort(changes_.begin(), changes_.end(),
                         [](const Change& a, const Change& b) { return a.height < b.height; });
    }

    void add_plane(const MovingLine& line, std::size_t point, int course) {
        start_.planes.add(line);
        start_.profile.push_back(profile_of(point));
        owners_.push_back({static_cast<int>(point), course});
    }

    // The line goes on from where it is at that height, at another speed.
    void add_courses(std::size_t point) {
        const Profile& profile = options_.profiles[static_cast<std::size_t>(profile_of(point))];
        int below = static_cast<int>(point);
        for (std::size_t k = 1; k < profile.courses.size(); ++k) {
            const MovingLine before = start_.planes[below];
            const std::int64_t height = scaled_height(profile.courses[k].from_m);
            const std::int64_t speed = speed_of(profile.courses[k].slope_deg);
            const Int128 offset = before.offset + static_cast<Int128>(before.speed - speed) * height;
            if (!(std::abs(static_cast<double>(offset)) < kHighestOffset))
                throw PlanError("a profile reaches too far beyond this plan");
            add_plane(moving_line(before.nx, before.ny, static_cast<std::int64_t>(offset), speed), point,
                      static_cast<int>(k));
            const auto above = static_cast<int>(start_.planes.size()) - 1;
            changes_.push_back({height, below, above});
            below = above;
        }
    }

    // Do the lines meet where the points are?
    void check_corners() const {
        const double most = 0.25 * plan_.near_units / kUnitsPerScaled;
        for (std::size_t i = 0; i < plan_.points.size(); ++i) {
            const auto edge = static_cast<int>(i);
            const int next = plan_.next[i];
            const auto& p = plan_.points[static_cast<std::size_t>(next)];
            const glm::dvec2 at(static_cast<double>(p.x) / kUnitsPerScaled, static_cast<double>(p.y) / kUnitsPerScaled);
            const ExactPlanes& planes = start_.planes;
            const bool is_straight = planes.is_parallel(edge, next);
            const bool is_there =
                is_straight ? planes[edge].offset == planes[next].offset && planes.has_direction_of(edge, next)
                            : glm::distance(planes.point(edge, next, 0), at) < most;
            if (!is_there)
                throw PlanError(fmt::format("edges {} and {} are too nearly parallel", plan_.edge[i],
                                            plan_.edge[static_cast<std::size_t>(next)]));
        }
    }

    void run(Wavefront& front) {
        const std::int64_t end = options_.height_m ? std::max<std::int64_t>(1, scaled_height(*options_.height_m)) : 0;
        for (std::size_t i = 0; i < changes_.size() && front.is_alive();) {
            const std::int64_t height = changes_[i].height;
            if (options_.height_m && height >= end) break;
            std::vector<std::pair<int, int>> now;
            for (; i < changes_.size() && changes_[i].height == height; ++i)
                now.emplace_back(changes_[i].from, changes_[i].to);
            front.run_to(height);
            if (front.is_alive()) front.change_planes(height, now);
        }
        if (options_.height_m) {
            front.run_to(end);
        } else {
            front.run_out();
        }
        if (front.has_run_wild()) throw PlanError("its wavefront does not come to an end");
        if (!front.is_alive()) return;
        if (!options_.height_m) throw PlanError("nothing closes it above: give a height where it ends");
        front.truncate(end);
    }

    const CheckedPlan& plan_;
    const RoofOptions& options_;
    double metres_per_scaled_ = 1;
    Wavefront::Start start_;
    std::vector<PlaneOwner> owners_;
    std::vector<Change> changes_;
};

}  // namespace

Roof straight_skeleton(const Plan& plan, const RoofOptions& options) {
    const CheckedPlan is_one = checked(plan);
    return Builder(is_one, options).roof();
}

}  // namespace quadrat::mesh
