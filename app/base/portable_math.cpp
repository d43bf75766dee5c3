// SPDX-License-Identifier: Apache-2.0
#include "base/portable_math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace quadrat::base {
namespace {

// ln 2 in two parts, so that k ln 2 is exact in the first for every exponent k.
constexpr double kLn2High = 0x1.62e42fefa3800p-1;
constexpr double kLn2Low = 0x1.ef35793c76730p-45;

double two_to(int k) { return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52U); }

constexpr double kInverseRootTwoPi = 0.398942280401432677939946;

}  // namespace

double portable_exp(double x) {
    if (std::isnan(x)) return x;
    if (x < -708) return 0;
    if (x > 709) return std::numeric_limits<double>::infinity();
    const double k = std::floor(x / kLn2High + 0.5);
    const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| ≤ 0.347: 14 terms of the series leave 1e-17
    double sum = 1;
    for (int n = 14; n >= 1; --n) sum = 1 + sum * r / n;
    const int exponent = static_cast<int>(k);
    return exponent > 1000 ? sum * two_to(1000) * two_to(exponent - 1000) : sum * two_to(exponent);
}

double portable_log(double x) {
    if (!(x > 0)) return x == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    if (std::isinf(x)) return x;
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // exact: no rounding
    if (m < 0.70710678118654752) {
        m *= 2;
        --exponent;
    }
    // ln m = 2 artanh(s), |s| ≤ 0.172: 11 terms leave 1e-18.
    const double s = (m - 1) / (m + 1);
    const double s2 = s * s;
    double sum = 0;
    for (int n = 21; n >= 1; n -= 2) sum = sum * s2 + 1.0 / n;
    return exponent * kLn2High + (2 * s * sum + exponent * kLn2Low);
}

double normal_density(double x) { return kInverseRootTwoPi * portable_exp(-0.5 * x * x); }

// Near 0 the series of Marsaglia (2004), "Evaluating the normal distribution"; in the tails the continued fraction of
// Laplace, which converges where the series would cancel.
double normal_cumulative(double x) {
    const double a = std::abs(x);
    if (std::isnan(x)) return x;
    if (a < 4) {
        double term = x;
        double sum = x;
        for (int n = 1; n < 80; ++n) {
            term = term * x * x / (2 * n + 1);
            sum += term;
        }
        return 0.5 + sum * normal_density(x);
    }
    double fraction = a;
    for (int n = 40; n >= 1; --n) fraction = a + n / fraction;
    const double tail = normal_density(a) / fraction;
    return x < 0 ? tail : 1 - tail;
}

}  // namespace quadrat::base
