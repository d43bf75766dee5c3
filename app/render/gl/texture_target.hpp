// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// A framebuffer for drawing into textures, one after another. Software rasterisers finish all that was drawn so far
// before they read a texture that was ever a target: what many frames read is better copied from one.
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

        // What was drawn, from the lower left on, into so many rows of another texture's level: all of their pixels.
        void copy_to(const Texture2D& texture, int level, int first_row, int rows) const;

      private:
        GLint before_ = 0;
        GLint read_before_ = 0;
    };
    [[nodiscard]] Drawing onto(const Texture2D& texture) const { return {framebuffer_, texture}; }

  private:
    // Goes with its context: a display's own framebuffers may have the same name in the context after it.
    GLuint framebuffer_ = 0;
};

}  // namespace quadrat::render::gl
