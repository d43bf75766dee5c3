// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "scene/scene.hpp"

// A small landscape made by hand: a valley with a lake, hills, two kinds of tree and some grass. It does not change
// when the growers do, so what its pictures show is the renderer's doing alone.
namespace quadrat::tests {

enum class Hour { Noon, Sunset, Night, Storm, Snow, Fog };
enum class Ground { Meadow, Desert };

std::shared_ptr<const scene::Scene> handmade_scene(Hour hour, Ground ground);

}  // namespace quadrat::tests
