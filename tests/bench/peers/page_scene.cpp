// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/page_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures/scene_export.hpp"
#include "pictures/tree_export.hpp"

namespace quadrat::peers {
namespace {

constexpr std::size_t kWorthLevels = 64;  // blades

// Any prefix of a species' leaves, enlarged to cover as much, is a coarser crown.
mesh::Model::Part fewer_leaves(scene::Species species, const std::string& name, std::size_t one_of) {
    scene::Leaves& leaves = species.leaves;
    leaves.indices.resize(leaves.blades / one_of * leaves.indices_per_blade());
    const std::size_t used = leaves.indices.empty() ? 0 : std::size_t{*std::ranges::max_element(leaves.indices)} + 1;
    leaves.vertices.resize(used);
    for (scene::Leaves::Vertex& v : leaves.vertices) v.corner_m *= std::sqrt(static_cast<float>(one_of));
    return pictures::leaves_part(species, name);
}

}  // namespace

mesh::Model page_scene(const scene::Scene& scene) {
    mesh::Model model = pictures::scene_model(scene, pictures::Instances::Shared);
    const auto add = [&model](mesh::Model::Part part) {
        model.placed.push_back({model.parts.size()});
        model.parts.push_back(std::move(part));
    };
    const std::vector<scene::Species>& kinds = scene.flora->species;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const scene::Species& species = kinds[i];
        if (species.leaves.blades < kWorthLevels) continue;
        const std::string name = fmt::format("species{}", i);
        add({name + "_wood_mid", species.wood.back().mesh, species.bark_colour});
        mesh::Model::Part mid = fewer_leaves(species, name, 4);
        mid.name += "_mid";
        mesh::Model::Part far = fewer_leaves(species, name, 16);
        if (!species.masses.empty()) far.mesh = species.masses.back().mesh;
        far.name += "_far";
        add(std::move(mid));
        add(std::move(far));
    }
    return model;
}

}  // namespace quadrat::peers
