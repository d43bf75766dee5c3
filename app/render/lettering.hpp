// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec4.hpp>
#include <string>

#include "mesh/image.hpp"

namespace quadrat::render {

struct TextStyle {
    std::string typeface = "Lato, Noto Sans, sans-serif";  // Pango falls back by script
    float size_px = 32;                                    // of the em
    bool is_bold = false;
    int max_width_px = 0;  // wraps beyond it; 0 never wraps
    glm::vec4 colour{1, 1, 1, 1};
    float shadow_px = 2;  // soft dark halo that keeps letters readable over any picture; 0 none
};

// Text in any script, shaped by Pango. RGBA, premultiplied, just large enough. Empty text gives a 1 x 1 clear image.
mesh::Image letter(const std::string& utf8, const TextStyle& style);

// The four quarters' shapes, known without reading: circle, triangle, square, diamond, filled, with the letter inside.
enum class Shape { Circle, Triangle, Square, Diamond };
// Of the letter in a badge, its em to the badge's side: in the triangle, which has the least room.
inline constexpr float kSmallestLetterOfBadge = 0.40F;
mesh::Image badge(Shape shape, const std::string& letter_in_it, glm::vec4 colour, int size_px);

}  // namespace quadrat::render
