// SPDX-License-Identifier: Apache-2.0
#include "scene/ground_colours.hpp"

#include <algorithm>
#include <cassert>

namespace quadrat::scene {
namespace {

// Malvar & Sullivan 2003, YCoCg, within a byte each.
struct Split {
    int brightness, orange, green;
};

Split split(const std::uint8_t* rgb) {
    const int r = rgb[0];
    const int g = rgb[1];
    const int b = rgb[2];
    return {(r + 2 * g + b + 2) / 4, r - b, 2 * g - r - b};
}

glm::u8vec3 joined(int brightness, int orange, int green) {
    const auto byte = [](int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); };
    const int rest = brightness - green;
    return {byte(rest + orange), byte(brightness + green), byte(rest - orange)};
}

int rounded(int sum, int count) { return (sum >= 0 ? sum + count / 2 : sum - count / 2) / count; }

}  // namespace

GroundColours::GroundColours(const mesh::Image& rgba) : width_(rgba.width), height_(rgba.height) {
    assert(rgba.channels == 4);
    brightness_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    shared_.reserve(static_cast<std::size_t>((width_ + 1) / 2) * static_cast<std::size_t>((height_ + 1) / 2));
    const auto around = [](int value) { return static_cast<std::uint8_t>(std::clamp(value + 128, 0, 255)); };
    for (int y = 0; y < height_; y += 2) {
        for (int x = 0; x < width_; x += 2) {
            int orange = 0;
            int green = 0;
            int wetness = 0;
            for (int k = 0; k < 4; ++k) {
                const int column = std::min(x + k % 2, width_ - 1);
                const int row = std::min(y + k / 2, height_ - 1);
                const std::uint8_t* pixel = rgba.pixel(column, row);
                const Split s = split(pixel);
                brightness_[static_cast<std::size_t>(row * width_ + column)] = static_cast<std::uint8_t>(s.brightness);
                orange += s.orange;
                green += s.green;
                wetness += pixel[3];
            }
            shared_.push_back({around(rounded(orange, 8)), around(rounded(green, 16)),
                               static_cast<std::uint8_t>(rounded(wetness, 4))});
        }
    }
}

glm::u8vec3 GroundColours::colour(int x, int y) const {
    const Shared& s = shared(x, y);
    return joined(brightness(x, y), s[0] - 128, s[1] - 128);
}

void GroundColours::mean_row(int halvings, int row, std::span<std::uint8_t> to) const {
    const int side = 1 << halvings;
    const int columns = width_ >> halvings;
    assert(to.size() >= 4 * static_cast<std::size_t>(columns));
    std::uint8_t* pixel = to.data();
    const auto put = [&pixel](const glm::u8vec3& colour) {
        for (int c = 0; c < 3; ++c) *pixel++ = colour[c];
        *pixel++ = 0;
    };
    if (halvings == 0) {
        const std::uint8_t* own = brightness_.data() + row * width_;
        const Shared* of_two = &shared(0, row);
        for (int x = 0; x < columns; ++x) {
            const Shared& s = of_two[x >> 1];
            put(joined(own[x], s[0] - 128, s[1] - 128));
        }
        return;
    }
    const int power = 2 * halvings;
    const auto mean = [](int sum, int of) { return (sum + (1 << of >> 1)) >> of; };
    for (int x = 0; x < width_ - side + 1; x += side) {
        int sum = 0;
        int orange = 0;
        int green = 0;
        for (int y = row * side; y < (row + 1) * side; y += 2) {
            const std::uint8_t* upper = brightness_.data() + y * width_ + x;
            const std::uint8_t* lower = upper + width_;
            const Shared* of_two = &shared(x, y);
            for (int dx = 0; dx < side; dx += 2) {
                const Shared& s = of_two[dx >> 1];
                orange += s[0] - 128;
                green += s[1] - 128;
                sum += upper[dx] + upper[dx + 1] + lower[dx] + lower[dx + 1];
            }
        }
        put(joined(mean(sum, power), mean(orange, power - 2), mean(green, power - 2)));
    }
}

}  // namespace quadrat::scene
