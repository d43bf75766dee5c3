// SPDX-License-Identifier: Apache-2.0
// G. Matheron, "The intrinsic random functions and their applications", 1973: with variogram -phi, the best estimate of
// a field from values at points is c + sum w_i phi(|p - p_i|), with sum w_i = 0 and the values met.
#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "synthesis/land/field_methods.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kLargest = 8193;

void require(bool is_right, const std::string& message) {
    if (!is_right) throw base::InputError(message);
}

void check(const FieldRequest& r) {
    require(r.size >= 2 && r.size <= kLargest,
            fmt::format("size is {}; a field has 2 to {} samples a side", r.size, kLargest));
    const noise::Window& w = r.window;
    require(w.columns == 0 || (w.columns > 0 && w.rows > 0 && w.column >= 0 && w.row >= 0 &&
                               w.columns <= r.size - w.column && w.rows <= r.size - w.row),
            fmt::format("window {},{},{},{} does not lie inside a field of {} samples a side", w.column, w.row,
                        w.columns, w.rows, r.size));
    require(r.octaves >= 1 && r.octaves <= 16, fmt::format("octaves is {}; 1 to 16 are right", r.octaves));
    require(r.gain > 0 && r.gain <= 1, fmt::format("gain is {}; more than 0, to 1 is right", r.gain));
    require(r.features > 0 && r.features <= 1024,
            fmt::format("features is {}; more than 0, to 1024 is right", r.features));
    require(r.fixed.size() <= kMostFixedPoints,
            fmt::format("{} fixed points; at most {} can be met", r.fixed.size(), kMostFixedPoints));
    std::set<std::pair<int, int>> places;
    for (const FixedPoint& p : r.fixed) {
        require(p.column >= 0 && p.row >= 0 && p.column < r.size && p.row < r.size,
                fmt::format("fixed point {} {} lies outside a field of {} samples a side", p.column, p.row, r.size));
        require(std::isfinite(p.height),
                fmt::format("the height of fixed point {} {} is not a number", p.column, p.row));
        require(places.insert({p.column, p.row}).second,
                fmt::format("fixed point {} {} is given twice", p.column, p.row));
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

void carry(mesh::Field& field, const noise::Window& w, const std::vector<FixedPoint>& points,
           const std::vector<double>& weights, float unit) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, w.rows, 4), [&](const auto& rows) {
        for (int row = rows.begin(); row != rows.end(); ++row) {
            float* line = field.samples.data() + field.index(0, row);
            for (int x = 0; x < w.columns; ++x) line[x] += static_cast<float>(weights.back());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const float dy = static_cast<float>(w.row + row - points[i].row) * unit;
                const auto weight = static_cast<float>(weights[i]);
                for (int x = 0; x < w.columns; ++x) {
                    const float dx = static_cast<float>(w.column + x - points[i].column) * unit;
                    const float r = std::sqrt(dx * dx + dy * dy);
                    line[x] += weight * r * std::sqrt(r);
                }
            }
        }
    });
}

}  // namespace

mesh::Field make_field(const FieldMethod& method, const FieldRequest& request) {
    check(request);
    mesh::Field field = method.make(request);
    if (request.fixed.empty()) return field;
    const noise::Window w =
        request.window.columns > 0 ? request.window : noise::Window{0, 0, request.size, request.size};
    std::vector<double> residuals;
    for (const FixedPoint& p : request.fixed) {
        FieldRequest there = request;
        there.window = {p.column, p.row, 1, 1};
        residuals.push_back(static_cast<double>(p.height) - method.make(there).at(0, 0));
    }
    const float unit = 1.0F / static_cast<float>(request.size - 1);
    carry(field, w, request.fixed, estimate(request.fixed, residuals, unit), unit);
    // What rounding left.
    for (const FixedPoint& p : request.fixed)
        if (field.is_inside(p.column - w.column, p.row - w.row))
            field.at(p.column - w.column, p.row - w.row) = p.height;
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
