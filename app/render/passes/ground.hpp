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
#include "scene/scene.hpp"

namespace quadrat::render::passes {

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
    gl::Texture2D lit;    // the root of half of what the ground sends to the eye; alpha: how deep water over it looks
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
    std::size_t index_count = 0;
};

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Scene>& scene);

// A run of indices in the frame's index stream.
struct IndexRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

// The land's square. What it is made of and the light baked for it are multiplied while uploading, for the sun stands
// still: a pixel fetches their product.
class GroundPass {
  public:
    GroundPass();
    void draw(const LandOnGpu& land, const gl::StreamBuffer& indices, IndexRange range) const;

  private:
    gl::Program program_;
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
    void draw(const StoneOnGpu& stone) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
