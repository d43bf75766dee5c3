// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"

// What passes are compared with, on whatever machine this is: the least that others draw the same with. Each clears the
// canvas and fills it.
namespace quadrat::benches {

// A lit ground without a picture of its light: squares of two triangles, a trilinear texture of 512 x 512, Lambert's
// law a pixel, fog a vertex.
class PlainGround {
  public:
    explicit PlainGround(int squares_a_side);
    void draw(const display::Canvas& canvas) const;

  private:
    render::gl::Program program_;
    render::gl::VertexArray vertices_;
    render::gl::Buffer places_;
    render::gl::Buffer order_;
    render::gl::Texture2D texture_;
};

// A sky without clouds: the five terms of Perez for luminance and both chromaticities a pixel (Preetham, Shirley, Smits
// 1999, appendix A.2).
class PlainSky {
  public:
    PlainSky();
    void draw(const display::Canvas& canvas) const;

  private:
    render::gl::Program program_;
    render::gl::VertexArray vertices_;
};

}  // namespace quadrat::benches
