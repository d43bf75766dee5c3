// SPDX-License-Identifier: Apache-2.0
#include "pictures/paste.hpp"

#include <algorithm>

namespace quadrat::pictures {

void paste(const mesh::Image& over, mesh::Image& onto, int left, int top) {
    for (int y = std::max(0, -top); y < std::min(over.height, onto.height - top); ++y) {
        for (int x = std::max(0, -left); x < std::min(over.width, onto.width - left); ++x) {
            const std::uint8_t* from = over.pixel(x, y);
            std::uint8_t* to = onto.pixel(left + x, top + y);
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<std::uint8_t>(std::min(255, from[c] + to[c] * (255 - from[3]) / 255));
        }
    }
}

}  // namespace quadrat::pictures
