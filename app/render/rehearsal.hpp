// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/scene.hpp"

namespace quadrat::render {

// A very small scene with a little of all that any scene may have: near and far ground, stone, sea and river, trees
// near enough for their leaves and so far that they are a mass, clouds, stars, a disc, a rainbow, rain.
scene::Scene rehearsal_scene();
scene::Camera rehearsal_camera();

}  // namespace quadrat::render
