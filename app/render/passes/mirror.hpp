// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec4.hpp>
#include <memory>

#include "render/gl/buffer.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/texture_pool.hpp"
#include "scene/scene.hpp"

namespace quadrat::render::passes {

// The std140 mirror of shaders/common/mirror.glsl, which says what each number is.
struct MirrorBlock {
    glm::vec4 place{0};
    glm::vec4 ripple{0};
    std::array<float, scene::Mirror::kBearings> shore_m{};
};
inline constexpr unsigned kMirrorBinding = 2;

// How a scene's water is moved: ripple 0 a mirror to 1 broken by the wind.
glm::vec4 ripple_block(float ripple);

// What a scene's water shows.
struct MirrorOnGpu {
    std::shared_ptr<const gl::Texture2D> picture;  // rgb: shown
    gl::Buffer block;
};

// Adds the slices that fill mirror, which must stay where it is until they are done. A scene without a mirror has one
// of its sky alone.
void add_mirror(gl::Slices& slices, MirrorOnGpu& mirror, const std::shared_ptr<gl::TexturePool>& pool,
                const std::shared_ptr<const scene::Scene>& scene);

}  // namespace quadrat::render::passes
