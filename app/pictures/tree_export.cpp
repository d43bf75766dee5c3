// SPDX-License-Identifier: Apache-2.0
#include "pictures/tree_export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "scene/tree_parameters.hpp"
#include "synthesis/trees/flora.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/species.hpp"

namespace quadrat::pictures {
namespace {

using namespace synthesis::trees;

scene::Wood meshed(const TreeSkeleton& skeleton, Limbs limbs) {
    if (limbs == Limbs::Swept) return sweep_tubes(skeleton, {});
    if (limbs == Limbs::Cylinders) return mesh_cylinders(skeleton, 8);
    const glm::vec3 size = skeleton.high_m - skeleton.low_m;
    MetaTubeDetail detail;
    detail.cell_m = std::max({size.x, size.y, size.z}) / 256;
    detail.sweeps_twigs = false;
    return mesh_meta_tubes(skeleton, detail);
}

}  // namespace

Limbs limbs_from(const std::string& name) {
    if (name == "drawn") return Limbs::AsDrawn;
    if (name == "smooth") return Limbs::Smooth;
    if (name == "swept") return Limbs::Swept;
    if (name == "cylinders") return Limbs::Cylinders;
    throw base::InputError(fmt::format("--limbs {}: there are drawn, smooth, swept and cylinders", name));
}

mesh::Model::Part leaves_part(const scene::Species& species, const std::string& name) {
    mesh::Model::Part part{name + "_leaves", {}, {}};
    glm::vec3 colour{0};
    for (const scene::Leaves::Vertex& v : species.leaves.vertices) {
        part.mesh.positions_m.push_back(v.site_m + v.corner_m);
        part.mesh.normals.push_back(v.normal);
        colour += v.colour;
    }
    part.mesh.indices = species.leaves.indices;
    if (!species.leaves.vertices.empty()) part.colour = colour / static_cast<float>(species.leaves.vertices.size());
    return part;
}

mesh::Model tree_model(const genome::Recipe& recipe, Limbs limbs) {
    const Form form = form_of(scene::realise_trees(recipe.values), Rank::First);
    const base::Seed seed = seed_of_species(recipe.seeds[genome::Aspect::Trees], 0);
    const scene::Species species = make_species(form, seed);
    mesh::Model model;
    if (limbs == Limbs::AsDrawn)
        model.parts.push_back({"tree_wood", species.wood.front().mesh, species.bark_colour});
    else
        model.parts.push_back({"tree_wood", meshed(skeleton_of_species(form, seed), limbs).mesh, species.bark_colour});
    model.parts.push_back(leaves_part(species, "tree"));
    return model;
}

}  // namespace quadrat::pictures
