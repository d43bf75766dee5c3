// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>

#include "render/gl/handles.hpp"
#include "render/gl/processor_spread.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// Where views are drawn smaller than they are shown: for GPUs that cannot shade every pixel in time. Made when it is
// first needed.
class ReducedTarget {
  public:
    enum class SpreadBy { Shader, Processor };
    explicit ReducedTarget(SpreadBy);
    // The framebuffer to draw to, at least this large; 0 where this GPU makes none.
    GLuint of(glm::ivec2 size);
    // Its lower left corner, spread over all of that framebuffer, smoothly. Leaves no test enabled.
    void show(glm::ivec2 drawn, GLuint framebuffer, glm::ivec2 size);

  private:
    void spread(glm::ivec2 drawn, glm::ivec2 size) const;

    Program spread_;
    std::optional<ProcessorSpread> processor_;
    // Goes with its context: a display's own framebuffers may have the same name in the context after it.
    GLuint framebuffer_ = 0;
    Texture2D colour_;
    TextureName depth_;
    bool is_whole_ = false;
};

}  // namespace quadrat::render::gl
