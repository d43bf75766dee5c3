// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <string>

#include "mesh/image.hpp"

namespace quadrat::pictures {

// A landscape to take home on paper: DIN A6 across, at 300 dots per inch.
inline constexpr glm::ivec2 kPostcard_px{1748, 1240};
inline constexpr glm::ivec2 kOnPostcard_px{1628, 700};  // of it, the landscape

struct Postcard {
    mesh::Image landscape;  // RGBA, as large as kOnPostcard_px
    std::string title;      // what it is in words, a line each phrase; becomes smaller until it fits
    std::string below;      // where and when; may be empty
    std::string code;       // that any Quadrat draws it from, as a QR code; empty: none
    bool reads_right_to_left = false;
};

// The picture as it lies on a card: as much of its middle as fills kOnPostcard_px. It must have pixels, RGBA.
mesh::Image filling_postcard(const mesh::Image& picture);

// White, opaque RGBA. Without the code where it is too long for one that a telephone reads from paper.
mesh::Image draw_postcard(const Postcard& card);

}  // namespace quadrat::pictures
