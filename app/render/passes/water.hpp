// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>

#include "render/choose/sectors.hpp"
#include "render/choose/water_levels.hpp"
#include "render/gl/buffer_pool.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "render/passes/mirror.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// Lakes and rivers of one land.
struct FreshWaterOnGpu {
    std::shared_ptr<gl::Buffer> corners;
    std::shared_ptr<gl::Buffer> indices;
    choose::WaterLevels levels;
};
void add_fresh_water(gl::Slices& slices, FreshWaterOnGpu& water, const std::shared_ptr<gl::BufferPool>& pool,
                     const std::shared_ptr<const scene::Land>& land);

// The sea at y = 0, from under the eye to the horizon.
class WaterPass {
  public:
    WaterPass();
    // ground's alpha: how deep the water over it looks.
    gl::Work draw(const gl::Texture2D& ground, const MirrorOnGpu& mirror, const choose::Frustum& frustum,
                  glm::vec3 eye_m, const choose::Reach& reach = {}) const;
    gl::Work draw_fresh(const FreshWaterOnGpu& water, const gl::Texture2D& ground, const MirrorOnGpu& mirror,
                        std::span<const choose::Range> seen) const;

  private:
    void bind_pictures(const gl::Texture2D& ground, const MirrorOnGpu& mirror) const;

    gl::Program program_;
    gl::Program fresh_program_;
    gl::VertexArray fresh_vertices_;
    gl::VertexArray vertices_;
    gl::Buffer rings_;
    gl::Buffer indices_;
    gl::Texture2D ripples_;
    choose::Sectors sectors_;
};

}  // namespace quadrat::render::passes
