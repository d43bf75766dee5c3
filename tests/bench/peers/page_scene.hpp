// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/model.hpp"
#include "scene/scene.hpp"

namespace quadrat::peers {

// The landscape as `quadrat export` writes it, and beside each part with many leaves, or their wood, what a page may
// draw from afar in its place, once each and at the origin: "NAME_mid", the coarsest wood or a quarter of the leaves,
// twice the size; "NAME_far", the crown as one mass or a sixteenth of the leaves. What has neither is not worth drawing
// from afar.
mesh::Model page_scene(const scene::Scene& scene);

}  // namespace quadrat::peers
