// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/model.hpp"
#include "scene/scene.hpp"

namespace quadrat::pictures {

// The ground as one mesh, a vertex a sample of its heights, in its colour as seen from far.
mesh::Model::Part land_part(const scene::Land& land);

// Shared: plants of a species share its meshes, as in glTF, in the finest level. WrittenOut: the file will repeat them
// plant by plant, as in OBJ, where the coarsest wood must do.
enum class Instances { Shared, WrittenOut };
// The land and everything that is planted on it. No sky, water or houses.
mesh::Model scene_model(const scene::Scene& scene, Instances instances);

}  // namespace quadrat::pictures
