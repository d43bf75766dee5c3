// SPDX-License-Identifier: Apache-2.0
#include "pictures/relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"

namespace quadrat::pictures {
namespace {

constexpr float kTilt = 0.55F;  // of depth shown as height on the picture
constexpr std::array<std::uint8_t, 3> kPaper{34, 36, 38};

// From low to high.
glm::vec3 colour_of(float share) {
    constexpr std::array<std::uint32_t, 5> kRamp{0x5C7F8A, 0x7E9A62, 0xB9A871, 0x9A8B7C, 0xF3F2EE};
    const float at = glm::clamp(share, 0.0F, 1.0F) * static_cast<float>(kRamp.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
    return scene::mix_colours(scene::linear_from_srgb_hex(kRamp[first]), scene::linear_from_srgb_hex(kRamp[first + 1]),
                              at - static_cast<float>(first));
}

struct Range {
    float low, high;
    float share(float height) const { return (height - low) / std::max(high - low, 1.0e-6F); }
};

glm::vec3 shaded(const mesh::Field& height, const Range& range, float column, float row, float rise) {
    const glm::vec3 sun = glm::normalize(glm::vec3{-0.6F, 0.75F, -0.45F});
    const float h = mesh::sample(height, column, row);
    const float dx = mesh::sample(height, column + 1, row) - mesh::sample(height, column - 1, row);
    const float dz = mesh::sample(height, column, row + 1) - mesh::sample(height, column, row - 1);
    const glm::vec3 normal = glm::normalize(glm::vec3{-dx * rise, 2.0F, -dz * rise});
    const float light = 0.30F + 0.85F * std::max(glm::dot(normal, sun), 0.0F);
    return colour_of(range.share(h)) * light;
}

}  // namespace

// Column by column from the front to the back, over what stands before.
mesh::Image draw_relief(const mesh::Field& height, int side_px, float exaggeration) {
    mesh::Image image(side_px, side_px, 4);
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = i % 4 == 3 ? 255 : kPaper[i % 4];
    if (height.samples.empty()) return image;
    const auto [low, high] = std::minmax_element(height.samples.begin(), height.samples.end());
    const Range range{*low, *high};
    const auto last = static_cast<float>(side_px - 1);
    const float rise_px = 0.5F * exaggeration * last;
    const float rise = exaggeration * 0.5F * static_cast<float>(height.columns - 1);  // in samples
    const float foot_px = last - 4.0F;
    const int steps = 2 * side_px;
    for (int x = 0; x < side_px; ++x) {
        int top = side_px;  // the highest row painted so far
        const float column = static_cast<float>(x) / last * static_cast<float>(height.columns - 1);
        for (int step = 0; step < steps; ++step) {
            const float share = 1.0F - static_cast<float>(step) / static_cast<float>(steps - 1);
            const float row = share * static_cast<float>(height.rows - 1);
            const float h = mesh::sample(height, column, row);
            const float y = foot_px - (1.0F - share) * kTilt * last - (h - range.low) * rise_px;
            const int row_px = std::clamp(static_cast<int>(y), 0, side_px);
            if (row_px >= top) continue;
            // The block's cut front is darker than its top.
            const glm::vec3 colour =
                step == 0 ? glm::vec3{0.10F, 0.08F, 0.065F} : shaded(height, range, column, row, rise);
            for (; top > row_px; --top)
                for (int c = 0; c < 3 && static_cast<float>(top - 1) <= foot_px; ++c)
                    image.pixel(x, top - 1)[c] = scene::srgb_byte(colour[c]);
        }
    }
    return image;
}

}  // namespace quadrat::pictures
