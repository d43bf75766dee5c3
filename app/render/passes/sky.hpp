// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <memory>

#include "render/choose/sectors.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/texture_pool.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "scene/sky.hpp"

namespace quadrat::render::passes {

struct SkyOnGpu {
    gl::Buffer dome;  // a shown colour for each vertex of the dome: between them it is smooth
    // The lower: as seen from the land, r: opacity, g: light weighted by it; the upper: its tile, r: density, g: lit.
    std::array<std::shared_ptr<const gl::Texture2D>, 2> clouds;
    mesh::Image shadow_map;  // the lower clouds' density, coarse: what falls on plants
    gl::Buffer shadow;       // of the lower clouds: shaders/common/cloud_shadow.glsl
    gl::Texture2D disc;
    bool has_disc = false;
    gl::Buffer stars;
    std::size_t star_count = 0;
    float bow = 0;
};

// Adds the slices that fill sky, which must stay where it is until they are done.
void add_sky(gl::Slices& slices, SkyOnGpu& sky, const std::shared_ptr<gl::TexturePool>& pool,
             const std::shared_ptr<const scene::Sky>& source);

// Dome, two layers of cloud, stars, the sun's or the moon's disc, a rainbow: behind all else.
class SkyPass {
  public:
    SkyPass();
    // The dome and the clouds. Leaves depth as it is.
    gl::Work draw_dome(const SkyOnGpu& sky, const choose::Frustum& frustum, glm::vec3 eye_m) const;
    // The same from a picture of them: from clip xy and 1 to its coordinates; so much of its light is kept.
    gl::Work draw_held(const gl::Texture2D& held, const glm::mat3& held_from_view, float kept) const;
    // What is too small or too bright to be held in a picture, added to either.
    gl::Work draw_lights(const SkyOnGpu& sky, int height_px, float share_of_stars) const;

  private:
    gl::Program program_;
    gl::Program held_;
    gl::Program disc_;
    gl::Program stars_;
    gl::Program bow_;
    gl::VertexArray vertices_;
    gl::VertexArray disc_vertices_;
    gl::VertexArray star_vertices_;
    gl::VertexArray bow_vertices_;
    gl::Buffer disc_corners_;
    gl::Buffer directions_;
    gl::Buffer indices_;
    gl::Buffer bow_corners_;
    gl::Buffer bow_indices_;
    choose::Sectors sectors_;
    std::size_t bow_index_count_ = 0;
};

}  // namespace quadrat::render::passes
