// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/choose/house_levels.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/passes/grid.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

struct HousesOnGpu {
    gl::Buffer corners;
    gl::Buffer looks;
    gl::Texture2D stains;
    choose::HouseLevels levels;
};

// Adds the slices that fill houses, which must stay where it is until they are done.
void add_houses(gl::Slices& slices, HousesOnGpu& houses, const std::shared_ptr<const scene::Land>& land);

// Houses, and what bounds their plots.
class HousesPass {
  public:
    HousesPass();
    gl::Work draw(const HousesOnGpu& houses, const gl::StreamBuffer& indices, const choose::IndexRange& range) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
