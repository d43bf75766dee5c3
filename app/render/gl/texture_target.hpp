// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// A framebuffer for drawing into textures, one after another. Software rasterisers finish all that was drawn so far
// before they read a texture that was ever a target, and may keep its memory long after it is deleted: what many frames
// read is better copied from one that stays.
class TextureTarget {
  public:
    TextureTarget() { glGenFramebuffers(1, &framebuffer_); }
    TextureTarget(const TextureTarget&) = delete;
    TextureTarget& operator=(const TextureTarget&) = delete;

    // While it lives, what is drawn goes into the texture's finest level, all of it the viewport; no test is enabled.
    class Drawing {
      public:
        Drawing(GLuint framebuffer, const Texture2D& texture);
        ~Drawing();
        Drawing(const Drawing&) = delete;
        Drawing& operator=(const Drawing&) = delete;

      private:
        GLint before_ = 0;
    };
    [[nodiscard]] Drawing onto(const Texture2D& texture) const { return {framebuffer_, texture}; }
    // The finest level of a texture into that of another of its shape.
    void copy(const Texture2D& from, const Texture2D& to) const;

  private:
    // Goes with its context: a display's own framebuffers may have the same name in the context after it.
    GLuint framebuffer_ = 0;
};

}  // namespace quadrat::render::gl
