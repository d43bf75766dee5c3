// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "scene/scene.hpp"

namespace quadrat::pictures {

// A camera that shows one tree of the first species from its sunny side: the one that stands most by itself. Nothing
// where the scene has no such tree.
std::optional<scene::Camera> camera_on_a_tree(const scene::Scene& scene);

}  // namespace quadrat::pictures
