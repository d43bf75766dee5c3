// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>

#include "mesh/image.hpp"
#include "render/gl/fence.hpp"
#include "render/gl/handles.hpp"
#include "render/renderer.hpp"

namespace quadrat::render {

// A small picture of a frame, for who looks from afar: the GPU makes it smaller and brings it across while the show
// goes on, and the processor fetches it in slices over the frames to come. No call waits for the GPU.
class Glimpse {
  public:
    // Of what was drawn into the frame's framebuffer last, at most so wide, in pixels. False, and nothing is done,
    // while one is on its way, or where this GPU can make none.
    bool begin(const Frame& frame, int most_width);
    // Once a frame: the picture when all of it is here, once. RGBA, to be taken for opaque, rows from the top.
    std::optional<mesh::Image> take();

  private:
    bool make(glm::ivec2 size);

    glm::ivec2 size_{0};
    // Goes with its context: a display's own framebuffers may have the same name in the context after it.
    GLuint framebuffer_ = 0;
    gl::RenderbufferName colour_;
    gl::BufferName bytes_;
    gl::Fence brought_;
    mesh::Image picture_;
    int rows_ = 0;  // of it that are here
    bool is_on_its_way_ = false;
};

}  // namespace quadrat::render
