// SPDX-License-Identifier: Apache-2.0
// H. Elias, "Cloud cover", 1998, as used in "Genetic selection of parametric scenes", 2003: with c = noise - (1 -
// cover), the density is 1 - s^c for c > 0. Ours reads the exponent as an optical depth, so that s = exp(-k), and takes
// the threshold from the noise's own distribution: a cover of a half hides half of the tile, whatever the noise.
#include "synthesis/sky/clouds.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>
#include <xsimd/xsimd.hpp>

#include "mesh/field.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::sky {
namespace {

using F = xsimd::batch<float, xsimd::default_arch>;

constexpr int kLightSteps = 6;

template <typename Row>
void for_rows(int rows, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows, 32), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

std::span<float> row_of(mesh::Field& field, int y) {
    return std::span(field.samples).subspan(field.index(0, y), static_cast<std::size_t>(field.columns));
}

// Rows of fBm that tiles, at equal steps over the tile.
void tiled_row(const noise::Key& key, int y, std::span<float> row, int rows, int masses,
               const noise::Octaves& octaves) {
    const float step = static_cast<float>(masses) / static_cast<float>(row.size());
    std::vector<float> us(row.size());
    for (std::size_t x = 0; x < us.size(); ++x) us[x] = step * static_cast<float>(x);
    const std::vector<float> vs(us.size(),
                                static_cast<float>(masses) * static_cast<float>(y) / static_cast<float>(rows));
    noise::fbm_tiled(key, us, vs, row, masses, octaves);
}

// Where the sky is bare and where closed: so smooth that a coarse field holds it.
class Clumps {
  public:
    Clumps(float strength, int side, base::Seed seed) : field_(kSide, kSide), side_(side) {
        if (strength <= 0) return;
        const noise::Key key(seed.child("clumps"));
        for (int y = 0; y < kSide; ++y) tiled_row(key, y, row_of(field_, y), kSide, 1, {.count = 2, .gain = 0.5F});
        for (float& f : field_.samples) f *= strength;
        strength_ = strength;
    }
    void add_to(std::span<float> row, int y) const {
        if (strength_ <= 0) return;
        const float at = static_cast<float>(y * kSide) / static_cast<float>(side_);
        const int above = static_cast<int>(at);
        const float down = at - static_cast<float>(above);
        std::array<float, kSide + 1> across{};
        for (int x = 0; x <= kSide; ++x) {
            const float top = field_.at(x % kSide, above);
            across[static_cast<std::size_t>(x)] = top + down * (field_.at(x % kSide, (above + 1) % kSide) - top);
        }
        const std::size_t run = row.size() / kSide;
        for (std::size_t cell = 0; cell < kSide; ++cell) {
            const float slope = (across[cell + 1] - across[cell]) / static_cast<float>(run);
            for (std::size_t i = 0; i < run; ++i) row[cell * run + i] += across[cell] + slope * static_cast<float>(i);
        }
    }

  private:
    static constexpr int kSide = 32;
    mesh::Field field_;
    float strength_ = 0;
    int side_;
};

mesh::Field cloud_noise(const CloudShape& shape, base::Seed seed) {
    mesh::Field noise(shape.side_px, shape.side_px);
    const noise::Key key(seed);
    const noise::Octaves octaves{.count = shape.octaves, .gain = shape.gain, .ridged = -shape.billow};
    const Clumps clumps(0.75F * shape.clumps, shape.side_px, seed);
    for_rows(shape.side_px, [&](int y) {
        const auto row = row_of(noise, y);
        tiled_row(key, y, row, shape.side_px, shape.masses, octaves);
        clumps.add_to(row, y);
    });
    return noise;
}

struct Spread {
    float threshold;  // above it lies the covered share
    float deviation;
};

// By a histogram of every third row: within a two-hundredth of the noise's range.
Spread spread_of(const mesh::Field& noise, float cover) {
    constexpr int kBins = 512;
    std::array<int, kBins> bins{};
    int count = 0;
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < noise.rows; y += 3) {
        for (int x = 0; x < noise.columns; ++x) {
            const float n = noise.at(x, y);
            ++bins[static_cast<std::size_t>(std::clamp(n * 0.5F + 0.5F, 0.0F, 0.9999F) * kBins)];
            sum += n;
            squares += static_cast<double>(n) * n;
            ++count;
        }
    }
    const double mean = sum / count;
    int left = static_cast<int>(static_cast<float>(count) * (1.0F - cover));
    std::size_t bin = 0;
    while (bin + 1 < bins.size() && left > bins[bin]) left -= bins[bin++];
    const float within = bins[bin] > 0 ? static_cast<float>(left) / static_cast<float>(bins[bin]) : 0.0F;
    const float threshold = (static_cast<float>(bin) + within) / kBins * 2.0F - 1.0F;
    return {threshold, static_cast<float>(std::sqrt(std::max(squares / count - mean * mean, 1.0e-6)))};
}

}  // namespace

mesh::Field cloud_depth(const CloudShape& shape, base::Seed seed) {
    assert(shape.side_px >= 32 && (shape.side_px & (shape.side_px - 1)) == 0);
    mesh::Field depth = cloud_noise(shape, seed);
    const Spread spread = spread_of(depth, std::clamp(shape.cover, 0.0F, 1.0F));
    const float steepness =
        (0.55F + 2.8F * shape.sharpness * shape.sharpness) * (0.6F + 0.9F * shape.thickness) / spread.deviation;
    // A closed sky is closed: what is left of its gaps fills from above.
    const float floor = 1.2F * std::max(0.0F, shape.cover - 0.88F) / 0.12F;
    for_rows(shape.side_px, [&](int y) {
        const auto row = row_of(depth, y);
        const F lowest(floor);
        for (std::size_t x = 0; x < row.size(); x += F::size) {
            const F d = (F::load_unaligned(&row[x]) - F(spread.threshold)) * F(steepness);
            xsimd::max(d, lowest).store_unaligned(&row[x]);
        }
    });
    return depth;
}

namespace {

// Adds a row that begins at a column, around the tile's seam.
void add_turned(std::span<float> to, std::span<const float> from, std::size_t first) {
    const std::size_t rest = from.size() - first;
    for (std::size_t x = 0; x < rest; ++x) to[x] += from[x + first];
    for (std::size_t x = rest; x < to.size(); ++x) to[x] += from[x - rest];
}

// Depth of cloud on the way to the sun, the mean of some steps over the tile.
void march(const mesh::Field& depth, const std::array<glm::ivec2, kLightSteps>& steps, int y,
           std::span<float> through) {
    std::ranges::fill(through, 0.0F);
    const int mask = depth.columns - 1;
    for (const glm::ivec2& step : steps) {
        const auto row = std::span(depth.samples)
                             .subspan(depth.index(0, (y + step.y) & mask), static_cast<std::size_t>(depth.columns));
        add_turned(through, row, static_cast<std::size_t>(step.x & mask));
    }
}

std::array<glm::ivec2, kLightSteps> steps_to(const glm::vec3& sun, const CloudShape& shape) {
    const float flat = std::max(std::hypot(sun.x, sun.z), 0.05F);
    // A low sun looks through more of the layer.
    const float stride_px =
        static_cast<float>(shape.side_px) / (42.0F * static_cast<float>(shape.masses)) * (0.6F + 1.2F * flat);
    std::array<glm::ivec2, kLightSteps> steps{};
    for (int i = 0; i < kLightSteps; ++i) {
        const auto s = static_cast<float>(i + 1) * stride_px;
        steps[static_cast<std::size_t>(i)] = {static_cast<int>(std::lround(s * sun.x / flat)),
                                              static_cast<int>(std::lround(s * sun.z / flat))};
    }
    return steps;
}

struct Sums {
    float density = 0;
    float light = 0;
};

// Seen from below: bright rims where the cloud is thin, shade where it is thick or stands behind another.
Sums write_row(std::span<const float> here, std::span<float> through, std::uint8_t* density, std::uint8_t* lit) {
    Sums sums;
    alignas(64) std::array<float, F::size> dense{};
    alignas(64) std::array<float, F::size> light{};
    for (std::size_t x = 0; x < here.size(); x += F::size) {
        const F depth = F::load_unaligned(&here[x]);
        const F before = F::load_unaligned(&through[x]) * F(1.0F / kLightSteps);
        const F own = xsimd::exp(F(-0.5F) * depth);
        const F rim = xsimd::min(xsimd::max(depth - before, F(-0.6F)), F(0.8F));
        const F sunlit = F(0.62F) * xsimd::exp(F(-0.95F) * before) + F(0.34F) * own + F(0.34F) * rim;
        const F opaque = F(255.0F) * (F(1.0F) - own * own) + F(0.5F);
        const F bright = xsimd::min(xsimd::max(F(255.0F) * sunlit, F(0.0F)), F(255.0F)) + F(0.4F);
        opaque.store_aligned(dense.data());
        bright.store_aligned(light.data());
        for (std::size_t i = 0; i < F::size; ++i) {
            density[x + i] = static_cast<std::uint8_t>(dense[i]);
            lit[x + i] = static_cast<std::uint8_t>(light[i]);
            sums.density += dense[i];
            sums.light += dense[i] * light[i];
        }
    }
    return sums;
}

}  // namespace

CloudImages make_clouds(const CloudShape& shape, const glm::vec3& sun, base::Seed seed) {
    if (shape.cover <= 0)
        return {mesh::Image(shape.side_px, shape.side_px, 1), mesh::Image(shape.side_px, shape.side_px, 1)};
    return light_clouds(cloud_depth(shape, seed), shape, sun);
}

CloudImages light_clouds(const mesh::Field& depth, const CloudShape& shape, const glm::vec3& sun) {
    const int side = shape.side_px;
    CloudImages images{mesh::Image(side, side, 1), mesh::Image(side, side, 1)};
    const auto steps = steps_to(sun, shape);
    std::vector<Sums> sums(static_cast<std::size_t>(side));
    for_rows(side, [&](int y) {
        std::vector<float> through(static_cast<std::size_t>(side));
        march(depth, steps, y, through);
        const auto here = std::span(depth.samples).subspan(depth.index(0, y), through.size());
        sums[static_cast<std::size_t>(y)] =
            write_row(here, through, images.density.pixel(0, y), images.lit.pixel(0, y));
    });
    const Sums all = std::accumulate(sums.begin(), sums.end(), Sums{}, [](const Sums& a, const Sums& b) {
        return Sums{a.density + b.density, a.light + b.light};
    });
    images.mean_density = all.density / (255.0F * static_cast<float>(side * side));
    images.mean_lit = all.density > 0 ? all.light / (255.0F * all.density) : 0.0F;
    return images;
}

}  // namespace quadrat::synthesis::sky
