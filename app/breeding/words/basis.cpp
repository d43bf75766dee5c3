// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/basis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/portable_math.hpp"

namespace quadrat::breeding {
namespace {

// Scenes nearer than this were described alike: one Gaussian serves them both.
constexpr double kSame = 0.05;
// In units of the mean distance to the nearest neighbours.
constexpr double kReach = 1.2;
constexpr double kSmallestRadius = 0.35;

double squared_distance(const Point& a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

// Farthest-point order (Gonzalez 1985), begun by the first point.
std::vector<Point> spread(std::span<const Point> points, std::size_t most) {
    std::vector<Point> chosen;
    std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
    std::size_t next = 0;
    while (chosen.size() < most && !points.empty()) {
        chosen.push_back(points[next]);
        for (std::size_t i = 0; i < points.size(); ++i)
            nearest[i] = std::min(nearest[i], squared_distance(chosen.back(), points[i]));
        next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
        if (nearest[next] < kSame * kSame) break;
    }
    return chosen;
}

double radius_of(const std::vector<Point>& centres, std::size_t which) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < centres.size(); ++i)
        if (i != which) distances.push_back(std::sqrt(squared_distance(centres[i], centres[which])));
    const std::size_t neighbours = std::min(distances.size(), centres[which].size() + 1);
    if (neighbours == 0) return 1;
    std::ranges::partial_sort(distances, distances.begin() + static_cast<std::ptrdiff_t>(neighbours));
    double sum = 0;
    for (std::size_t i = 0; i < neighbours; ++i) sum += distances[i];
    return std::max(kSmallestRadius, kReach * sum / static_cast<double>(neighbours));
}

}  // namespace

Basis::Basis(std::span<const Point> points)
    : dimensions_(points.empty() ? 0 : points.front().size()), centres_(spread(points, kMostCentres)) {
    for (std::size_t i = 0; i < centres_.size(); ++i) radii_.push_back(radius_of(centres_, i));
}

void Basis::evaluate(std::span<const double> at, std::span<double> values) const {
    assert(at.size() == dimensions_ && values.size() == size());
    for (std::size_t i = 0; i < centres_.size(); ++i)
        values[i] = base::portable_exp(-squared_distance(centres_[i], at) / (radii_[i] * radii_[i]));
    values[gaussians()] = 1;
    std::ranges::copy(at, values.begin() + static_cast<std::ptrdiff_t>(gaussians()) + 1);
}

}  // namespace quadrat::breeding
