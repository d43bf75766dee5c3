// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mesh/image.hpp"

// What people see who lack one kind of cone: Machado, Oliveira & Fernandes 2009, "A Physiologically-based Model for
// Simulation of Color Vision Deficiency", table 1, severity 1.0. The matrices are for linear light.
namespace quadrat::tests {

using Colour = std::array<double, 3>;  // linear
struct Vision {
    const char* name;
    std::array<Colour, 3> seen_from_shown;
};
inline constexpr std::array<Vision, 4> kVisions{{
    {"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
}};

inline double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
inline double srgb_of(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline Colour seen(const Vision& vision, const Colour& shown) {
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) colour[i] += vision.seen_from_shown[i][j] * shown[j];
        colour[i] = std::clamp(colour[i], 0.0, 1.0);
    }
    return colour;
}

inline double luminance(const Colour& linear) { return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]; }

inline mesh::Image picture_seen(const Vision& vision, mesh::Image picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            std::uint8_t* pixel = picture.pixel(x, y);
            Colour shown{};
            for (std::size_t i = 0; i < 3; ++i) shown[i] = linear_of(pixel[i] / 255.0);
            const Colour colour = seen(vision, shown);
            for (std::size_t i = 0; i < 3; ++i)
                pixel[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_of(colour[i])));
        }
    return picture;
}

}  // namespace quadrat::tests
