// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include <algorithm>

#include "render/renderer.hpp"

namespace quadrat::render {

mesh::Image Renderer::read_pixels(const Frame& frame) {
    const glm::ivec2 size = turned_size(frame.size, frame.hanging);
    mesh::Image image(size.x, size.y, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes.data());
    // GL has rows from the bottom.
    const auto row_bytes = static_cast<std::size_t>(size.x) * 4;
    for (int y = 0; y < image.height / 2; ++y) {
        std::uint8_t* row = image.pixel(0, y);
        std::swap_ranges(row, row + row_bytes, image.pixel(0, image.height - 1 - y));
    }
    return image;
}

}  // namespace quadrat::render
