// SPDX-License-Identifier: Apache-2.0
// G. Matheron, "The intrinsic random functions and their applications", 1973: with variogram -phi, the best estimate of
// a field from values at points is c + sum w_i phi(|p - p_i|), with sum w_i = 0 and the values met.
#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/land/field_methods.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kLargest = 8193;
constexpr float kHighest = 1.0e4F;

void require(bool is_right, const std::string& message) {
    if (!is_right) throw base::InputError(message);
}

void check_window(const FieldRequest& r) {
    const noise::Window& w = r.window;
    require(w.columns == 0 || (w.columns > 0 && w.rows > 0 && w.column >= 0 && w.row >= 0 &&
                               w.columns <= r.size - w.column && w.rows <= r.size - w.row),
            fmt::format("window {},{},{},{} does not lie inside a field of {} samples a side", w.column, w.row,
                        w.columns, w.rows, r.size));
}

void check_place(const FixedPoint& p, int size, std::string_view what) {
    require(p.column >= 0 && p.row >= 0 && p.column < size && p.row < size,
            fmt::format("{} {} {} lies outside a field of {} samples a side", what, p.column, p.row, size));
    require(std::isfinite(p.height), fmt::format("the height of {} {} {} is not a number", what, p.column, p.row));
    require(std::abs(p.height) <= kHighest, fmt::format("the height of {} {} {} is {}; -{} to {} is right", what,
                                                        p.column, p.row, p.height, kHighest, kHighest));
}

void check_line(const Line& line, int size) {
    require(line.corners.size() >= 2, "a line has two or more corners");
    for (const FixedPoint& p : line.corners) check_place(p, size, "corner");
    if (line.kind != Line::Kind::River) return;
    for (std::size_t i = 1; i < line.corners.size(); ++i)
        require(line.corners[i].height <= line.corners[i - 1].height,
                fmt::format("the river rises toward {} {}; write it from its spring to its mouth",
                            line.corners[i].column, line.corners[i].row));
}

// Every sample that is known, with its height.
using Known = std::map<std::pair<int, int>, float>;

void check_crossings(const FieldRequest& r) {
    Known known;
    for (const FixedPoint& p : r.fixed)
        require(known.insert({{p.column, p.row}, p.height}).second,
                fmt::format("fixed point {} {} is given twice", p.column, p.row));
    for (const Line& line : r.lines) {
        for (const FixedPoint& p : points_along(line.corners, 1)) {
            const float there = known.insert({{p.column, p.row}, p.height}).first->second;
            require(std::abs(there - p.height) <= 1.0e-5F * std::max(1.0F, std::abs(there)),
                    fmt::format("at {} {} two heights are asked for: {} and {}", p.column, p.row, there, p.height));
        }
    }
}

double phi(double squared) { return std::sqrt(squared * std::sqrt(squared)); }

// Gauss with partial pivoting; the matrix is square, row by row.
std::vector<double> solve(std::vector<double> m, std::vector<double> rhs) {
    const std::size_t n = rhs.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(m[i * n + k]) > std::abs(m[best * n + k])) best = i;
        if (best != k) {
            std::swap_ranges(m.begin() + k * n, m.begin() + (k + 1) * n, m.begin() + best * n);
            std::swap(rhs[k], rhs[best]);
        }
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(k + 1, n, 64), [&](const auto& rows) {
            for (std::size_t i = rows.begin(); i != rows.end(); ++i) {
                const double f = m[i * n + k] / m[k * n + k];
                for (std::size_t j = k; j < n; ++j) m[i * n + j] -= f * m[k * n + j];
                rhs[i] -= f * rhs[k];
            }
        });
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) rhs[k] -= m[k * n + j] * rhs[j];
        rhs[k] /= m[k * n + k];
    }
    return rhs;
}

// Weights of the points, then the constant.
std::vector<double> estimate(const std::vector<FixedPoint>& points, const std::vector<double>& residuals, double unit) {
    const std::size_t n = points.size();
    std::vector<double> m((n + 1) * (n + 1), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) {
            const double dx = (points[i].column - points[k].column) * unit;
            const double dy = (points[i].row - points[k].row) * unit;
            m[i * (n + 1) + k] = phi(dx * dx + dy * dy);
        }
        m[i * (n + 1) + n] = 1;
        m[n * (n + 1) + i] = 1;
    }
    std::vector<double> rhs = residuals;
    rhs.push_back(0);
    return solve(std::move(m), std::move(rhs));
}

// Of all lines together.
int corner_length(const std::vector<Line>& lines) {
    int length = 0;
    for (const Line& line : lines) length += static_cast<int>(points_along(line.corners, 1).size());
    return length;
}

}  // namespace

void check(const FieldRequest& r) {
    require(r.size >= 2 && r.size <= kLargest,
            fmt::format("size is {}; a field has 2 to {} samples a side", r.size, kLargest));
    check_window(r);
    require(r.octaves >= 1 && r.octaves <= 16, fmt::format("octaves is {}; 1 to 16 are right", r.octaves));
    require(r.gain > 0 && r.gain <= 1, fmt::format("gain is {}; more than 0, to 1 is right", r.gain));
    require(r.features > 0 && r.features <= 1024,
            fmt::format("features is {}; more than 0, to 1024 is right", r.features));
    require(r.fixed.size() <= kMostFixedPoints,
            fmt::format("{} fixed points; at most {} can be met", r.fixed.size(), kMostFixedPoints));
    std::size_t corners = 0;
    for (const Line& line : r.lines) corners += line.corners.size();
    require(corners <= kMostCorners, fmt::format("{} corners of lines; at most {} can be met", corners, kMostCorners));
    for (const FixedPoint& p : r.fixed) check_place(p, r.size, "fixed point");
    for (const Line& line : r.lines) check_line(line, r.size);
    check_crossings(r);
}

Conditions::Conditions(const FieldRequest& request, const Heights& without)
    : size_(request.size), reach_(0), fixed_(request.fixed), points_(request.fixed) {
    // Some of each line is carried; what is left between is no larger than their distance, and met beside the line.
    constexpr int kPointsOnLines = 500;
    const int step = std::max(4, corner_length(request.lines) / kPointsOnLines);
    reach_ = 2 * step;
    std::set<std::pair<int, int>> places;
    for (const FixedPoint& p : fixed_) places.insert({p.column, p.row});
    for (const Line& line : request.lines)
        for (const FixedPoint& p : points_along(line.corners, step))
            if (places.insert({p.column, p.row}).second) points_.push_back(p);
    std::vector<double> residuals;
    for (const FixedPoint& p : points_)
        residuals.push_back(static_cast<double>(p.height) - static_cast<double>(without(p.column, p.row)));
    if (!points_.empty()) weights_ = estimate(points_, residuals, 1.0F / static_cast<float>(size_ - 1));
    for (const Line& line : request.lines) {
        const float side = line.kind == Line::Kind::Ridge ? 1.0F : -1.0F;
        for (const FixedPoint& p : points_along(line.corners, 1)) {
            mesh::Field here(1, 1, without(p.column, p.row));
            carry(here, {p.column, p.row, 1, 1});
            on_lines_.push_back({p, p.height - here.at(0, 0), side});
        }
    }
}

void Conditions::apply(mesh::Field& part, const noise::Window& of) const {
    if (points_.empty()) return;
    carry(part, of);
    if (!on_lines_.empty()) meet_lines(part, of);
    // What rounding left.
    for (const FixedPoint& p : fixed_)
        if (part.is_inside(p.column - of.column, p.row - of.row))
            part.at(p.column - of.column, p.row - of.row) = p.height;
}

void Conditions::carry(mesh::Field& part, const noise::Window& of) const {
    const float unit = 1.0F / static_cast<float>(size_ - 1);
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, of.rows, 4), [&](const auto& rows) {
        for (int row = rows.begin(); row != rows.end(); ++row) {
            float* line = part.samples.data() + part.index(0, row);
            for (int x = 0; x < of.columns; ++x) line[x] += static_cast<float>(weights_.back());
            for (std::size_t i = 0; i < points_.size(); ++i) {
                const float dy = static_cast<float>(of.row + row - points_[i].row) * unit;
                const auto weight = static_cast<float>(weights_[i]);
                for (int x = 0; x < of.columns; ++x) {
                    const float dx = static_cast<float>(of.column + x - points_[i].column) * unit;
                    const float r = std::sqrt(dx * dx + dy * dy);
                    line[x] += weight * r * std::sqrt(r);
                }
            }
        }
    });
}

// Beside a line: what is left to add, and how high the line is, as means weighted by nearness (Shepard 1968).
void Conditions::meet_lines(mesh::Field& part, const noise::Window& of) const {
    struct Beside {
        float weight = 0;
        float residual = 0;
        float height = 0;
        float side = 0;
        float line_away = 1;   // to the reach
        float point_away = 1;  // of the nearest fixed point
    };
    mesh::Grid<Beside> beside(of.columns, of.rows);
    const auto over = [&](const FixedPoint& p, const auto& visit) {
        for (int y = std::max(p.row - reach_, of.row); y <= std::min(p.row + reach_, of.row + of.rows - 1); ++y) {
            for (int x = std::max(p.column - reach_, of.column);
                 x <= std::min(p.column + reach_, of.column + of.columns - 1); ++x) {
                const auto squared = static_cast<float>((x - p.column) * (x - p.column) + (y - p.row) * (y - p.row));
                const float away = std::sqrt(squared) / static_cast<float>(reach_);
                if (away < 1) visit(beside.at(x - of.column, y - of.row), squared, away);
            }
        }
    };
    for (const OnLine& s : on_lines_) {
        over(s.at, [&s](Beside& b, float squared, float away) {
            const float weight = (1 - away) * (1 - away) / (squared + 0.01F);
            b.weight += weight;
            b.residual += weight * s.residual;
            b.height += weight * s.at.height;
            b.side += weight * s.side;
            b.line_away = std::min(b.line_away, away);
        });
    }
    for (const FixedPoint& p : fixed_)
        over(p, [](Beside& b, float, float away) { b.point_away = std::min(b.point_away, away); });
    for (std::size_t i = 0; i < part.samples.size(); ++i) {
        const Beside& b = beside.samples[i];
        if (b.weight <= 0) continue;
        const float t = 1 - b.line_away;
        const float felt = t * t * (3 - 2 * t);
        float& h = part.samples[i];
        h += felt * b.residual / b.weight;
        // What stands over a crest, or lies under a bed, is turned down or up about it.
        const float side = b.side / b.weight;
        const float wrong = std::max(side * (h - b.height / b.weight), 0.0F);
        h -= 2 * felt * b.point_away * side * wrong;
    }
    for (const OnLine& s : on_lines_)
        if (part.is_inside(s.at.column - of.column, s.at.row - of.row))
            part.at(s.at.column - of.column, s.at.row - of.row) = s.at.height;
}

mesh::Field make_field(const FieldMethod& method, const FieldRequest& asked) {
    check(asked);
    require(!asked.pictures || method.takes_pictures,
            fmt::format("{} has no noise that pictures could stand in for", method.name));
    const FieldRequest request = prepared(method, asked);
    mesh::Field field = method.make(request);
    if (request.fixed.empty() && request.lines.empty()) return field;
    const noise::Window whole{0, 0, request.size, request.size};
    FieldRequest alone = request;
    alone.fixed.clear();
    alone.lines.clear();
    const Conditions conditions(request, [&](int column, int row) {
        alone.window = {column, row, 1, 1};
        return method.make(alone).at(0, 0);
    });
    conditions.apply(field, request.window.columns > 0 ? request.window : whole);
    return field;
}

std::vector<FixedPoint> points_along(std::span<const FixedPoint> polyline, int step) {
    std::vector<FixedPoint> points;
    std::set<std::pair<int, int>> places;
    const auto add = [&](const FixedPoint& p) {
        if (places.insert({p.column, p.row}).second) points.push_back(p);
    };
    if (!polyline.empty()) add(polyline.front());
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        const FixedPoint& a = polyline[i - 1];
        const FixedPoint& b = polyline[i];
        const int longest = std::max(std::abs(b.column - a.column), std::abs(b.row - a.row));
        const int parts = std::max(1, (longest + std::max(step, 1) - 1) / std::max(step, 1));
        for (int k = 1; k <= parts; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(parts);
            const auto between = [t](int from, int to) {
                return from + static_cast<int>(std::lround(t * static_cast<float>(to - from)));
            };
            add({between(a.column, b.column), between(a.row, b.row), a.height + t * (b.height - a.height)});
        }
    }
    return points;
}

}  // namespace quadrat::synthesis::land
