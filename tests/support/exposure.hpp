// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/core.h>

#include <string>

#include "mesh/image.hpp"

// How bright a picture is, and when it is too bright or too dark to be shown.
namespace quadrat::tests {

struct Exposure {
    double mean = 0;   // of luma, 0 to 1, as encoded
    double white = 0;  // share of pixels that are pure white
    double black = 0;  // share that are pure black
};

inline Exposure exposure_of(const mesh::Image& picture) {
    Exposure e;
    const auto pixels = static_cast<double>(picture.width) * picture.height;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* p = picture.pixel(x, y);
            e.mean += (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / (255 * pixels);
            e.white += (p[0] == 255 && p[1] == 255 && p[2] == 255) / pixels;
            e.black += (p[0] == 0 && p[1] == 0 && p[2] == 0) / pixels;
        }
    }
    return e;
}

// Empty: may be shown. A night may be darker.
inline std::string fault_of(const Exposure& e, bool is_night) {
    if (e.mean < (is_night ? 0.05 : 0.12) || e.mean > 0.75) return fmt::format("mean luminance {:.3f}", e.mean);
    if (e.white > 0.02) return fmt::format("{:.1f} % pure white", 100 * e.white);
    if (e.black > 0.25) return fmt::format("{:.1f} % pure black", 100 * e.black);
    return {};
}

}  // namespace quadrat::tests
