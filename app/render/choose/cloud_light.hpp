// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "mesh/image.hpp"
#include "render/choose/view_block.hpp"

namespace quadrat::render::choose {

// What the lower clouds leave of the light on a point, 0 to 1: the mirror of shaders/common/cloud_shadow.glsl, for
// plants. density: one channel, tileable, a power of two a side; empty: no clouds.
float cloud_light_at(const ViewBlock& view, const mesh::Image& density, const glm::vec3& at_m);

}  // namespace quadrat::render::choose
