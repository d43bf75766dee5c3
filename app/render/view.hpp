// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/passes/view_block.hpp"
#include "render/renderer.hpp"

namespace quadrat::render {

// The view's uniform block at this time.
passes::ViewBlock block_of(const View& view, const glm::mat4& clip_from_world, float seconds);

float aspect_ratio(const View& view);

// As if its panel hung upright.
glm::mat4 clip_from_world_of(const View& view);

// How large a thing one metre high looks at one metre's distance, in the middle of the view.
float pixels_per_radian(const View& view);

}  // namespace quadrat::render
