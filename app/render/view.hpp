// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "render/choose/view_block.hpp"
#include "render/renderer.hpp"

namespace quadrat::render {

// The view's uniform block at this time.
choose::ViewBlock block_of(const View& view, const glm::mat4& clip_from_world, float seconds);

float aspect_ratio(const View& view);

// From a direction to clip x, y and w: where it ends does not depend on how long it is.
glm::mat3 clip_from_direction(const glm::mat4& clip_from_world);

// The part of a view between these clip x, as all of one.
glm::mat4 strip_of(glm::mat4 clip_from_world, glm::vec2 between);

// As if its panel hung upright.
glm::mat4 clip_from_world_of(const View& view);

// How large a thing one metre high looks at one metre's distance, in the middle of the view.
float pixels_per_radian(const View& view);

}  // namespace quadrat::render
