// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/word_gaussian.hpp"

#include <cassert>

namespace quadrat::breeding {
namespace {

// Before any example: a word is within its ends, and knows nothing of the others.
constexpr double kPriorVariance = 0.35;
// A person's own error in saying a word.
constexpr double kSpoken = 0.03;

}  // namespace

WordGaussian::WordGaussian(std::size_t dimensions) : mean_(dimensions, 0.0), covariance_(dimensions * dimensions, 0.0) {
    for (std::size_t i = 0; i < dimensions; ++i) covariance_[i * dimensions + i] = kPriorVariance;
}

WordGaussian::WordGaussian(std::span<const Point> points, std::span<const double> weights, std::size_t dimensions)
    : WordGaussian(dimensions) {
    assert(points.size() == weights.size());
    const double prior = static_cast<double>(dimensions);
    double total = prior;
    for (std::size_t e = 0; e < points.size(); ++e) {
        total += weights[e];
        for (std::size_t i = 0; i < dimensions; ++i) mean_[i] += weights[e] * points[e][i];
    }
    for (double& m : mean_) m /= total;
    for (double& c : covariance_) c *= prior / total;
    for (std::size_t e = 0; e < points.size(); ++e)
        for (std::size_t i = 0; i < dimensions; ++i)
            for (std::size_t j = 0; j < dimensions; ++j)
                covariance_[i * dimensions + j] +=
                    weights[e] / total * (points[e][i] - mean_[i]) * (points[e][j] - mean_[j]);
}

WordGaussian WordGaussian::given(std::span<const double> direction, double value, double deviation) const {
    const std::size_t n = dimensions();
    assert(direction.size() == n);
    Point gain(n, 0.0);
    double predicted = 0;
    double variance = deviation * deviation;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) gain[i] += covariance_[i * n + j] * direction[j];
        predicted += direction[i] * mean_[i];
        variance += direction[i] * gain[i];
    }
    WordGaussian next = *this;
    for (std::size_t i = 0; i < n; ++i) {
        next.mean_[i] += gain[i] * (value - predicted) / variance;
        for (std::size_t j = 0; j < n; ++j) next.covariance_[i * n + j] -= gain[i] * gain[j] / variance;
    }
    return next;
}

WordGaussian WordGaussian::given(std::size_t word, double value) const {
    Point direction(dimensions(), 0.0);
    direction[word] = 1;
    return given(direction, value, kSpoken);
}

}  // namespace quadrat::breeding
