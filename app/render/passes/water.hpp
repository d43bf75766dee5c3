// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/passes/chunks.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// Lakes and rivers of one land.
struct FreshWaterOnGpu {
    gl::Buffer corners;
    gl::Buffer indices;
    Chunks chunks;
};
void add_fresh_water(gl::Slices& slices, FreshWaterOnGpu& water, const std::shared_ptr<const scene::Scene>& scene);

// The sea at y = 0, from under the eye to the horizon.
class WaterPass {
  public:
    WaterPass();
    void draw(const gl::Texture2D& ground) const;  // its alpha: how deep the water over it looks
    // Returns how many triangles.
    std::size_t draw_fresh(const FreshWaterOnGpu& water, const gl::Texture2D& ground, const Frustum& frustum) const;
    std::size_t triangles() const { return index_count_ / 3; }

  private:
    void bind_pictures(const gl::Texture2D& ground) const;

    gl::Program program_;
    gl::Program fresh_program_;
    gl::VertexArray fresh_vertices_;
    gl::VertexArray vertices_;
    gl::Buffer rings_;
    gl::Buffer indices_;
    gl::Texture2D ripples_;
    std::size_t index_count_ = 0;
};

}  // namespace quadrat::render::passes
