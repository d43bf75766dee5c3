// SPDX-License-Identifier: Apache-2.0
// H. Elias, "Cloud cover", 1998, as used in "Genetic selection of parametric scenes", 2003: with c = noise - (1 -
// cover), the density is 1 - s^c for c > 0. Ours reads the exponent as an optical depth, so that s = exp(-k).
#include "synthesis/sky/clouds.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::sky {
namespace {

constexpr int kLightSteps = 7;

template <typename Row>
void for_rows(int rows, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

std::uint8_t byte_of(float unit) { return static_cast<std::uint8_t>(255.0F * std::clamp(unit, 0.0F, 1.0F) + 0.5F); }

// Depth of cloud over each point, 0 where there is none.
mesh::Field cloud_depth(const CloudShape& shape, base::Seed seed) {
    mesh::Field depth(shape.side_px, shape.side_px);
    const noise::Key key(seed);
    const auto side = static_cast<float>(shape.side_px);
    const float threshold = 0.62F - 1.12F * shape.cover;
    const float steepness = 1.5F + 7.0F * shape.sharpness * shape.sharpness;
    std::vector<float> us(shape.side_px);
    for (int x = 0; x < shape.side_px; ++x) us[x] = static_cast<float>(shape.masses) * static_cast<float>(x) / side;
    for_rows(shape.side_px, [&](int y) {
        const std::vector<float> vs(us.size(), static_cast<float>(shape.masses) * static_cast<float>(y) / side);
        const auto row = std::span(depth.samples).subspan(depth.index(0, y), us.size());
        noise::fbm_tiled(key, us, vs, row, shape.masses, {.count = shape.octaves, .gain = 0.52F});
        for (float& d : row) d = std::max(0.0F, (2.2F * d - threshold) * steepness);
    });
    return depth;
}

}  // namespace

CloudImages make_clouds(const CloudShape& shape, const glm::vec3& sun_direction, base::Seed seed) {
    const mesh::Field depth = cloud_depth(shape, seed);
    CloudImages images{mesh::Image(shape.side_px, shape.side_px, 1), mesh::Image(shape.side_px, shape.side_px, 1)};
    const float flat = std::max(std::hypot(sun_direction.x, sun_direction.z), 0.05F);
    // A low sun looks through more of the layer.
    const float stride_px =
        static_cast<float>(shape.side_px) / (50.0F * static_cast<float>(shape.masses)) * (0.7F + 1.3F * flat);
    const float dx = sun_direction.x / flat * stride_px;
    const float dy = sun_direction.z / flat * stride_px;
    const int side = shape.side_px;
    const auto wrapped = [side](float at) { return ((static_cast<int>(std::floor(at)) % side) + side) % side; };
    for_rows(side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const float here = depth.at(x, y);
            float through = 0;
            for (int i = 1; i <= kLightSteps; ++i) {
                const auto s = static_cast<float>(i);
                through += depth.at(wrapped(static_cast<float>(x) + s * dx), wrapped(static_cast<float>(y) + s * dy));
            }
            through /= static_cast<float>(kLightSteps);
            images.density.pixel(x, y)[0] = byte_of(1.0F - std::exp(-here));
            // Seen from below: bright rims where the cloud is thin, shade where it is thick or stands behind another.
            const float lit = 0.55F * std::exp(-0.75F * through) + 0.45F * std::exp(-0.55F * here) +
                              0.25F * std::clamp(here - through, -0.6F, 0.8F);
            images.lit.pixel(x, y)[0] = byte_of(lit);
        }
    });
    return images;
}

}  // namespace quadrat::synthesis::sky
