// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "genome/recipe.hpp"
#include "mesh/model.hpp"
#include "scene/flora.hpp"

namespace quadrat::pictures {

// How the limbs of an exported tree are meshed. AsDrawn: the finest level of the exhibit, thick limbs joined smoothly
// and twigs as tubes of their own. Smooth: every limb in one surface, in cells of a 256th of the tree. All are closed.
enum class Limbs { AsDrawn, Smooth, Swept, Cylinders };
Limbs limbs_from(const std::string& name);  // "drawn", "smooth", "swept", "cylinders"; throws InputError

// The scene's first species by itself: its wood, then its leaves.
mesh::Model tree_model(const genome::Recipe& recipe, Limbs limbs);

// Leaves carry their own vertices; other tools want them as one mesh in the leaves' mean colour.
mesh::Model::Part leaves_part(const scene::Species& species, const std::string& name);

}  // namespace quadrat::pictures
