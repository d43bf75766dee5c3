// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/field.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

// The share of the sky seen past the land, 0 to 1, from the horizon in eight directions; a quarter of the land's
// samples, between them.
mesh::Field sky_openness(const scene::Land& land);

// What a land's form alone does to the light of the sky, on the same places.
struct Openness {
    mesh::Field sky;    // sky_openness
    mesh::Field folds;  // 1 where it is even, less in gullies, more on ridges: under clouds nothing else shows its form
};
Openness openness_of(const scene::Land& land);

}  // namespace quadrat::synthesis
