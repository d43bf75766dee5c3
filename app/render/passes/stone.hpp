// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/choose/pieces.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/passes/grid.hpp"
#include "render/passes/ground_picture.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

struct StoneOnGpu {
    gl::Buffer corners;
    gl::Buffer facings;
    gl::Texture2D lichen;
    choose::Pieces pieces;
};

// Adds the slices that fill stone, which must stay where it is until they are done.
void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Land>& land);

// Boulders, arches, caves.
class StonePass {
  public:
    StonePass();
    // Of the land's picture it takes the grain.
    gl::Work draw(const StoneOnGpu& stone, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                  const choose::IndexRange& range) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
