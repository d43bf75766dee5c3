// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "mesh/image.hpp"
#include "render/passes/view_block.hpp"

namespace quadrat::render::passes {

// What the lower clouds leave of the light on a point, 0 to 1: the mirror of shaders/common/cloud_shadow.glsl, for
// plants. density: one channel, tileable, a power of two a side; empty: no clouds.
float cloud_light_at(const ViewBlock& view, const mesh::Image& density, const glm::vec3& at_m);

inline constexpr int kShadowSide = 32;  // samples

// A coarse copy to ask often, kShadowSide samples a side: means of the pixels. No density: no clouds.
mesh::Image shadow_map_of(const mesh::Image& density);

// The map as shaders/common/cloud_shadow.glsl reads it.
inline constexpr unsigned kShadowBinding = 1;
using ShadowTable = std::array<std::uint32_t, kShadowSide * kShadowSide>;
ShadowTable shadow_table(const mesh::Image& map);

}  // namespace quadrat::render::passes
