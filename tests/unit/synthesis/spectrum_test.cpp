// SPDX-License-Identifier: Apache-2.0
// The power spectrum of a fractal surface with exponent H falls as f^-(2H + 2) along the radius (Saupe 1988).
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "synthesis/land/field_methods.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using Complex = std::complex<double>;

constexpr int kSide = 512;

void fourier(Complex* values, int n, int stride) {
    if (n == 1) return;
    std::vector<Complex> half(n);
    fourier(values, n / 2, stride * 2);
    fourier(values + stride, n / 2, stride * 2);
    for (int k = 0; k < n / 2; ++k) {
        const Complex odd = std::polar(1.0, -2 * 3.14159265358979 * k / n) * values[(2 * k + 1) * stride];
        half[k] = values[2 * k * stride] + odd;
        half[k + n / 2] = values[2 * k * stride] - odd;
    }
    for (int k = 0; k < n; ++k) values[k * stride] = half[k];
}

std::vector<Complex> spectrum(const mesh::Field& field) {
    std::vector<Complex> grid(kSide * kSide);
    const auto hann = [](int i) { return 0.5 - 0.5 * std::cos(2 * 3.14159265358979 * i / kSide); };
    double mean = 0;
    for (const float h : field.samples) mean += h;
    mean /= static_cast<double>(field.samples.size());
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) grid[y * kSide + x] = (field.at(x, y) - mean) * hann(x) * hann(y);
    for (int y = 0; y < kSide; ++y) fourier(grid.data() + y * kSide, kSide, 1);
    for (int x = 0; x < kSide; ++x) fourier(grid.data() + x, kSide, kSide);
    return grid;
}

struct Bands {
    std::vector<double> power;  // a band an octave third
    std::vector<double> axis;   // the same within 8 degrees of the axes
    std::vector<double> diagonal;
};

// Mean power in bands of a third of an octave over two decades of frequency, over some fields.
Bands bands_of(const char* name, float gain) {
    constexpr int kBands = 20;
    std::vector<double> sum[3];
    std::vector<int> count[3];
    for (int k = 0; k < 3; ++k) {
        sum[k].assign(kBands, 0.0);
        count[k].assign(kBands, 0);
    }
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        land::FieldRequest r;
        r.size = kSide;
        r.seed = base::Seed{seed};
        r.gain = gain;
        r.features = 1.7F;
        const auto grid = spectrum(land::make_field(*land::field_method(name), r));
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const int fx = x < kSide / 2 ? x : x - kSide;
                const int fy = y < kSide / 2 ? y : y - kSide;
                const double f = std::hypot(fx, fy);
                if (f < 2 || f >= 200) continue;
                const int band = static_cast<int>(3 * std::log2(f / 2));
                const double angle = std::fmod(std::abs(std::atan2(fy, fx)) * 57.29578, 90.0);
                const double power = std::norm(grid[y * kSide + x]);
                const int kind = angle < 8 || angle > 82 ? 1 : angle > 37 && angle < 53 ? 2 : -1;
                sum[0][band] += power;
                ++count[0][band];
                if (kind > 0) {
                    sum[kind][band] += power;
                    ++count[kind][band];
                }
            }
        }
    }
    Bands bands;
    for (int i = 0; i < kBands; ++i) {
        if (count[0][i] == 0) continue;
        bands.power.push_back(sum[0][i] / count[0][i]);
        bands.axis.push_back(sum[1][i] / std::max(count[1][i], 1));
        bands.diagonal.push_back(sum[2][i] / std::max(count[2][i], 1));
    }
    return bands;
}

double slope_of(const std::vector<double>& power) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(power.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
        const double x = static_cast<double>(i) / 3;
        const double y = std::log2(power[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

class SpectralSlope : public testing::TestWithParam<const char*> {};

TEST_P(SpectralSlope, IsWithinATenthOfTheoryOverTwoDecades) {
    const float gain = 0.57435F;  // H = 0.8
    const double slope = slope_of(bands_of(GetParam(), gain).power);
    EXPECT_NEAR(slope, -(2 * 0.8 + 2), 0.1 * (2 * 0.8 + 2)) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Fractals, SpectralSlope,
                         testing::Values("fbm", "fbm-simplex", "diamond-square", "square-square", "triangle-edge",
                                         "bin-split"));

TEST(SquareSquare, HasNoDirectionOfItsOwnBeyondAFactorOfTwoAndAThird) {
    const Bands bands = bands_of("square-square", 0.57435F);
    double worst = 0;
    for (std::size_t i = 9; i < bands.power.size(); ++i)
        worst = std::max(worst, std::abs(std::log2(bands.axis[i] / bands.diagonal[i])));
    EXPECT_LT(worst, 1.2);
}

}  // namespace
