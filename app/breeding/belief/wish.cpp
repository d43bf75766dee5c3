// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/wish.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/portable_math.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kUniformDeviation = 0.28867513459481287;
constexpr double kPersonal = 0.16;       // of a wish from what archetypes span
constexpr double kArchetypeShare = 0.8;  // how much of their variance a wish near them has
constexpr double kEyeNoise = 0.08;       // of a comparison, in the same units as the scaled difference
constexpr double kUnknownWeights = 0.5;  // nobody cares for all coordinates alike
constexpr double kContrast = 6;          // scales a difference to where picks saturate
constexpr double kMeaningless = 0.10;    // share of picks that children make with their eyes elsewhere

}  // namespace

Wish isotropic_wish(std::size_t n) {
    Wish wish{Place(n, 0.5), std::vector<double>(n * n, 0.0), 0};
    for (std::size_t i = 0; i < n; ++i) wish.covariance[i * n + i] = kUniformDeviation * kUniformDeviation;
    return wish;
}

Wish archetype_wish(std::span<const Place> archetypes) {
    assert(!archetypes.empty());
    const std::size_t n = archetypes.front().size();
    const auto count = static_cast<double>(archetypes.size());
    Wish wish{Place(n, 0.0), std::vector<double>(n * n, 0.0), 0};
    for (const Place& place : archetypes)
        for (std::size_t i = 0; i < n; ++i) wish.mean[i] += place[i] / count;
    for (const Place& place : archetypes)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                wish.covariance[i * n + j] +=
                    kArchetypeShare * (place[i] - wish.mean[i]) * (place[j] - wish.mean[j]) / count;
    for (std::size_t i = 0; i < n; ++i) wish.covariance[i * n + i] += kPersonal * kPersonal;
    return wish;
}

namespace {

void take_in(Wish& wish, const Place& better, const Place& worse) {
    const std::size_t n = wish.mean.size();
    std::vector<double> along(n);
    double distance = 0;
    double unknown = 0;
    for (std::size_t i = 0; i < n; ++i) {
        along[i] = kContrast / static_cast<double>(n) * (better[i] - worse[i]);
        const double off = wish.mean[i] - (better[i] + worse[i]) / 2;
        distance += along[i] * off;
        unknown += along[i] * along[i] * (wish.covariance[i * n + i] + off * off);
    }
    std::vector<double> spread(n, 0.0);
    double variance = kEyeNoise * kEyeNoise + kUnknownWeights * unknown;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) spread[i] += wish.covariance[i * n + j] * along[j];
        variance += along[i] * spread[i];
    }
    const double deviation = std::sqrt(variance);
    const double z = distance / deviation;
    const double sure = 1 - kMeaningless;
    const double likely = kMeaningless / 2 + sure * base::normal_cumulative(z);
    const double slope = sure * base::normal_density(z) / likely;
    const double curvature = std::max(0.0, slope * (slope + z));
    for (std::size_t i = 0; i < n; ++i) {
        wish.mean[i] = std::clamp(wish.mean[i] + spread[i] * slope / deviation, 0.0, 1.0);
        for (std::size_t j = 0; j < n; ++j) wish.covariance[i * n + j] -= spread[i] * spread[j] * curvature / variance;
    }
    wish.evidence += base::portable_log(likely);
}

}  // namespace

Wish learnt(Wish wish, std::span<const Place> shown, std::size_t picked) {
    for (std::size_t other = 0; other < shown.size(); ++other)
        if (other != picked) take_in(wish, shown[picked], shown[other]);
    return wish;
}

std::vector<double> root_of(const Wish& wish) {
    const std::size_t n = wish.mean.size();
    std::vector<double> root(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = wish.covariance[i * n + j];
            for (std::size_t k = 0; k < j; ++k) sum -= root[i * n + k] * root[j * n + k];
            // Rounding may take a pivot to zero or just under it: that direction is then known.
            if (i == j)
                root[i * n + i] = std::sqrt(std::max(sum, 1e-12));
            else
                root[i * n + j] = sum / root[j * n + j];
        }
    return root;
}

Place drawn(const Wish& wish, const std::vector<double>& root, base::RandomStream& chance) {
    const std::size_t n = wish.mean.size();
    Place normal(n);
    for (double& x : normal) x = static_cast<double>(chance.normal());
    Place place = wish.mean;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) place[i] += root[i * n + j] * normal[j];
    return place;
}

}  // namespace quadrat::breeding
