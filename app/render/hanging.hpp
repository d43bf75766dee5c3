// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace quadrat::render {

// Pixels, origin at the bottom left as GL has it.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Rect&, const Rect&) = default;
};

// How the panel hangs, seen from the front, and whether the light comes from behind it. Everything is laid out upright;
// the projection turns it, which costs nothing and works on every panel.
struct Hanging {
    int quarter_turns = 0;  // of the panel, clockwise, 0 to 3
    bool is_mirrored = false;
    friend bool operator==(const Hanging&, const Hanging&) = default;
};

// The upright picture's size on a panel of this size, and the other way round.
glm::ivec2 turned_size(glm::ivec2 size, const Hanging& hanging);

// From upright to the panel: clip coordinates, and a rectangle of an upright picture of this size.
glm::mat2 panel_from_upright(const Hanging& hanging);
Rect on_panel(const Rect& upright, glm::ivec2 upright_size, const Hanging& hanging);

}  // namespace quadrat::render
