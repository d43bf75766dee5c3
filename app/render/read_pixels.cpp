// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include <cstring>

#include "render/renderer.hpp"

namespace quadrat::render {

mesh::Image Renderer::read_pixels(const Frame& frame) {
    const glm::ivec2 size = turned_size(frame.size, frame.hanging);
    mesh::Image upside_down(size.x, size.y, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.bytes.data());
    mesh::Image image(size.x, size.y, 4);
    const auto row_bytes = static_cast<std::size_t>(size.x) * 4;
    for (int y = 0; y < image.height; ++y)
        std::memcpy(image.pixel(0, y), upside_down.pixel(0, image.height - 1 - y), row_bytes);
    return image;
}

}  // namespace quadrat::render
