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
#include "render/passes/blocks.hpp"
#include "render/passes/chunks.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// The texture unit on which the lower clouds' shadow must lie when ground is drawn.
inline constexpr GLuint kShadowUnit = 2;

inline constexpr int kLandBlock = 16;  // samples a side of a block of the land

inline constexpr float kGrain = 0.55F;  // how much of the ground's brightness its grain is

// How far the grain is seen, where a radian has 1 pixel: beyond, its mean is left. m
inline constexpr float kGrainSeen_m = 0.12F;

// A heightfield's vertices; which of its triangles are drawn is chosen every frame.
struct GridOnGpu {
    gl::Buffer places;   // GridPlace a sample
    gl::Buffer facings;  // a normal and a colour a sample; the surround's only
    std::optional<Blocks> blocks;
    float cell_m = 1;
    float middle_column = 0;
};

struct LandOnGpu {
    GridOnGpu land;
    GridOnGpu surround;
    gl::Texture2D lit;    // what the ground sends to the eye, shown, its coarse relief in it; alpha: how deep water
                          // over it looks
    gl::Texture2D grain;  // of soft ground and of stone, in the light of the sun; 0.5 is level ground
    float side_m = 0;
    bool has_water = false;
};

// Adds the slices that fill land, which must stay where it is until they are done.
void add_land(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<const scene::Scene>& scene);

struct StoneOnGpu {
    gl::Buffer corners;
    gl::Buffer facings;
    gl::Buffer indices;
    Chunks chunks;
};

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Scene>& scene);

// A run of indices in the frame's index stream: near ground comes first in it.
struct IndexRange {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t near_count = 0;
};

// The land's square. What it is made of and the light baked for it are multiplied while uploading, for the sun stands
// still: a pixel fetches their product.
class GroundPass {
  public:
    GroundPass();
    // grain_m: how far it is seen.
    void draw(const LandOnGpu& land, const gl::StreamBuffer& indices, IndexRange range, float grain_m) const;

  private:
    gl::Program near_;
    gl::Program far_;
    gl::VertexArray vertices_;
};

// The country around it, to the horizon.
class SurroundPass {
  public:
    SurroundPass();
    void draw(const LandOnGpu& land, const gl::StreamBuffer& indices, IndexRange range) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

// Boulders, arches, caves.
class StonePass {
  public:
    StonePass();
    // Returns how many triangles.
    std::size_t draw(const StoneOnGpu& stone, const Frustum& frustum) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
