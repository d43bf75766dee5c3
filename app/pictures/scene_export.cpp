// SPDX-License-Identifier: Apache-2.0
#include "pictures/scene_export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pictures/tree_export.hpp"

namespace quadrat::pictures {
namespace {

mesh::Model::Part wood_of(const scene::Species& species, const std::string& name, std::size_t level) {
    return {name + "_wood", species.wood.at(std::min(level, species.wood.size() - 1)).mesh, species.bark_colour};
}

}  // namespace

mesh::Model::Part land_part(const scene::Land& land) {
    mesh::Model::Part part{"land", {}, land.far_colour};
    const int n = land.height_m.columns;
    const float middle = static_cast<float>(n - 1) / 2;
    for (int row = 0; row < land.height_m.rows; ++row) {
        for (int column = 0; column < n; ++column) {
            const glm::vec2 at{(static_cast<float>(column) - middle) * land.cell_m,
                               (static_cast<float>(row) - middle) * land.cell_m};
            part.mesh.positions_m.emplace_back(at.x, land.height_m.at(column, row), at.y);
            part.mesh.normals.push_back(scene::ground_normal(land, at));
            if (row + 1 == land.height_m.rows || column + 1 == n) continue;
            const auto a = static_cast<std::uint32_t>(land.height_m.index(column, row));
            const auto below = a + static_cast<std::uint32_t>(n);
            for (const std::uint32_t index : {a, below, a + 1, a + 1, below, below + 1})
                part.mesh.indices.push_back(index);
        }
    }
    return part;
}

mesh::Model scene_model(const scene::Scene& scene, Instances instances) {
    mesh::Model model;
    model.parts.push_back(land_part(*scene.land));
    model.placed.push_back({});
    for (std::size_t i = 0; i < scene.flora->species.size(); ++i) {
        const scene::Species& species = scene.flora->species[i];
        const std::string name = fmt::format("species{}", i);
        model.parts.push_back(wood_of(species, name, instances == Instances::WrittenOut ? 99 : 0));
        model.parts.push_back(leaves_part(species, name));
    }
    for (const scene::Plant& plant : scene.plants)
        for (std::size_t part = 0; part < 2; ++part)
            model.placed.push_back({1 + 2 * plant.species + part, plant.root_m, plant.yaw_rad, plant.scale});
    return model;
}

}  // namespace quadrat::pictures
