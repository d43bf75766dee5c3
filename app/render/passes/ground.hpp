// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/passes/grid.hpp"
#include "render/passes/ground_picture.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

inline constexpr int kLandBlock = 16;  // samples a side of a block of the land

// How far the grain is seen, where a radian has 1 pixel: beyond, its mean is left. m
inline constexpr float kGrainSeen_m = 0.45F;

struct LandOnGpu {
    GridOnGpu land;
    GridOnGpu surround;
    gl::Buffer facings;  // of the surround: a normal and a colour a sample
    float side_m = 0;
    bool has_water = false;
};

// Adds the slices that fill land, which must stay where it is until they are done.
void add_land(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<gl::BufferPool>& pool,
              const std::shared_ptr<const scene::Land>& source);
// The same for what the land's square is drawn of instead of its blocks.
void add_roam(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<const scene::Land>& source);

// The land's square.
class GroundPass {
  public:
    GroundPass();
    // grain_m: how far it is seen.
    gl::Work draw(const LandOnGpu& land, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                  const choose::IndexRange& range, float grain_m) const;

  private:
    gl::Program near_;
    gl::Program far_;
    gl::VertexArray vertices_;
};

// The country around it, to the horizon. Of the land's picture it takes the grain.
class SurroundPass {
  public:
    SurroundPass();
    gl::Work draw(const LandOnGpu& land, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                  const choose::IndexRange& range) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
