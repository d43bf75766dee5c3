// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <glm/vec2.hpp>

#include "render/gl/handles.hpp"

namespace quadrat::render::gl {

// Where a frame is drawn with several samples a pixel, so that edges are smooth. Made when it is first needed. A tiler
// keeps the samples on its chip: only their means are written out.
class MultisampledTarget {
  public:
    // The framebuffer to draw to, as large as `shown` and with its kind of pixels; 0 where this GPU cannot.
    GLuint of(glm::ivec2 size, int samples, GLuint shown);
    // Each pixel's mean to that framebuffer, which is left bound. Leaves no test enabled.
    void resolve(GLuint shown);
    void let_go();  // of its memory

  private:
    bool make(glm::ivec2 size, int samples, GLuint shown);

    GLuint framebuffer_ = 0;  // goes with its context
    RenderbufferName colour_;
    RenderbufferName depth_;
    glm::ivec2 size_{0};
    int samples_ = 0;
    bool is_whole_ = false;
};

// The most samples a pixel that this GPU should be asked for by itself: 4, or 1 where it has fewer or is a processor,
// which would take four times as long.
int most_samples(bool is_on_processor);

}  // namespace quadrat::render::gl
