// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <memory>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "scene/sky.hpp"

namespace quadrat::render::passes {

struct SkyOnGpu {
    gl::Buffer dome;                      // a shown colour for each vertex of the dome: between them it is smooth
    std::array<gl::Texture2D, 2> clouds;  // r: density, g: lit
};

// Adds the slices that fill sky, which must stay where it is until they are done.
void add_sky(gl::Slices& slices, SkyOnGpu& sky, const std::shared_ptr<const scene::Sky>& source);

// Dome, sun and two layers of cloud, behind all else.
class SkyPass {
  public:
    SkyPass();
    void draw(const SkyOnGpu& sky) const;
    std::size_t triangles() const { return index_count_ / 3; }

  private:
    gl::Program program_;
    gl::Program sun_;
    gl::VertexArray vertices_;
    gl::VertexArray sun_vertices_;
    gl::Buffer sun_corners_;
    gl::Buffer directions_;
    gl::Buffer indices_;
    std::size_t index_count_ = 0;
};

}  // namespace quadrat::render::passes
