// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/image.hpp"
#include "scene/ground_colours.hpp"

namespace quadrat::tests {

using Bytes = std::array<std::uint8_t, 3>;  // sRGB
inline constexpr Bytes kEarth{130, 115, 90};

// Ground of one colour all over.
inline scene::GroundColours plain_colour(const Bytes& colour) {
    mesh::Image picture(64, 64, 4);
    for (std::size_t i = 0; i < picture.bytes.size(); i += 4)
        std::ranges::copy(colour, picture.bytes.begin() + static_cast<std::ptrdiff_t>(i));
    return scene::GroundColours(picture);
}

}  // namespace quadrat::tests
