// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/choose/view_block.hpp"

namespace quadrat::render::choose {

// What shaders/common/haze.glsl works out for a point: the air's shown colour, and how much of it lies before the
// point.
glm::vec4 haze_at(const ViewBlock& view, glm::vec3 at_m);

}  // namespace quadrat::render::choose
