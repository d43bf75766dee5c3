// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

#include "mesh/image.hpp"

namespace quadrat::render::passes {

inline constexpr int kShadowSide = 32;  // samples

// A coarse copy for choose::cloud_light_at() to ask often, kShadowSide samples a side: means of the pixels. No density:
// no clouds.
mesh::Image shadow_map_of(const mesh::Image& density);

// The map as shaders/common/cloud_shadow.glsl reads it.
inline constexpr unsigned kShadowBinding = 1;
using ShadowTable = std::array<std::uint32_t, kShadowSide * kShadowSide>;
ShadowTable shadow_table(const mesh::Image& map);

}  // namespace quadrat::render::passes
