// SPDX-License-Identifier: Apache-2.0
#include "render/hanging.hpp"

namespace quadrat::render {

glm::ivec2 turned_size(glm::ivec2 size, const Hanging& hanging) {
    return hanging.quarter_turns % 2 == 0 ? size : glm::ivec2{size.y, size.x};
}

glm::mat2 panel_from_upright(const Hanging& hanging) {
    // A panel turned clockwise has its top at the viewer's right: what is up for the viewer lies at its left.
    const glm::mat2 turn{glm::vec2{0, 1}, glm::vec2{-1, 0}};
    glm::mat2 all{hanging.is_mirrored ? -1.0F : 1.0F, 0, 0, 1};
    for (int i = 0; i < hanging.quarter_turns; ++i) all = turn * all;
    return all;
}

Rect on_panel(const Rect& upright, glm::ivec2 upright_size, const Hanging& hanging) {
    Rect r = upright;
    glm::ivec2 size = upright_size;
    if (hanging.is_mirrored) r.x = size.x - r.x - r.width;
    for (int i = 0; i < hanging.quarter_turns; ++i) {
        r = {size.y - r.y - r.height, r.x, r.height, r.width};
        size = {size.y, size.x};
    }
    return r;
}

}  // namespace quadrat::render
