// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <memory>

#include "render/choose/reach.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "scene/land.hpp"

namespace quadrat::render::passes {

struct SmokeOnGpu {
    gl::Buffer corners;
    gl::Buffer indices;
    std::size_t puffs = 0;
};

// Adds the slices that fill smoke, which must stay where it is until they are done.
void add_smoke(gl::Slices& slices, SmokeOnGpu& smoke, const std::shared_ptr<const scene::Land>& land);

// Smoke from chimneys, blended over all else; it costs nothing where there is none.
class SmokePass {
  public:
    SmokePass();
    // growth: the share of the chimneys that smoke already, the oldest houses' first.
    gl::Work draw(const SmokeOnGpu& smoke, glm::vec2 wind_m_s, float growth, const choose::Reach& reach) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace quadrat::render::passes
