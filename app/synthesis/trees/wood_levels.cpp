// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/wood_levels.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/nearness.hpp"
#include "synthesis/trees/limb_mesh.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr std::size_t kSmoothTriangles = 3600;
constexpr std::size_t kTwigNodes = 420;  // beside them

// Of three values at a triangle's corners, that of a point on it.
float between(const mesh::Mesh& mesh, const std::vector<float>& values, const mesh::Nearness::Nearest& on) {
    const std::uint32_t* corner = &mesh.indices[3 * std::size_t{on.triangle}];
    const glm::vec3 a = mesh.positions_m[corner[0]];
    const glm::vec3 b = mesh.positions_m[corner[1]];
    const glm::vec3 c = mesh.positions_m[corner[2]];
    const float of_a = glm::length(glm::cross(b - on.at_m, c - on.at_m));
    const float of_b = glm::length(glm::cross(c - on.at_m, a - on.at_m));
    const float of_c = glm::length(glm::cross(a - on.at_m, b - on.at_m));
    const float all = of_a + of_b + of_c;
    if (all <= 0) return values[corner[0]];
    return (values[corner[0]] * of_a + values[corner[1]] * of_b + values[corner[2]] * of_c) / all;
}

}  // namespace

std::vector<scene::Wood> wood_levels(const TreeSkeleton& skeleton) {
    MetaTubeDetail smooth;
    smooth.cell_m = cell_for(skeleton, kSmoothTriangles);
    smooth.most_nodes = kTwigNodes + 4 * skeleton.limbs.front().nodes.size();
    smooth.twig_sides = 3;
    std::vector<scene::Wood> levels{mesh_meta_tubes(skeleton, smooth)};
    const std::size_t trunk = skeleton.limbs.front().nodes.size();
    struct Level {
        int sides;
        std::size_t nodes;  // beside the trunk's
        float flattest;
    };
    constexpr Level kLevels[] = {{8, 260, 0.15F}, {6, 90, 0.4F}, {4, 26, 0.9F}, {3, 0, 2.0F}};
    for (const Level& level : kLevels) {
        TubeDetail detail;
        detail.trunk_sides = level.sides;
        detail.most_nodes = trunk + level.nodes;
        detail.flattest = level.flattest;
        levels.push_back(sweep_tubes(skeleton, detail));
    }
    return levels;
}

void add_spindle(std::vector<scene::Wood>& levels, float height_m, float radius_m) {
    scene::Wood wood;
    resize_vertices(wood, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const bool is_top = i == 3;
        const float turn = 2.0944F * static_cast<float>(i);
        const glm::vec3 outward = is_top ? glm::vec3{0, 1, 0} : glm::vec3{std::cos(turn), 0, -std::sin(turn)};
        const float up_m = is_top ? 0.85F * height_m : 0;
        wood.mesh.positions_m[i] = is_top ? glm::vec3{0, up_m, 0} : outward * radius_m * 1.15F;
        wood.mesh.normals[i] = outward;
        wood.mesh.texcoords[i] = {is_top ? 0 : 1.4F * radius_m, up_m};
        wood.grains[i] = {0, 1, 0, 1};
        wood.ages[i] = is_top ? 0.6F : 0;
        wood.sways[i] = is_top ? 0.3F : 0;
    }
    wood.mesh.indices = {0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
    levels.push_back(std::move(wood));
}

void set_coarser(std::vector<scene::Wood>& levels) {
    for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
        scene::Wood& wood = levels[level];
        const scene::Wood& next = levels[level + 1];
        if (next.mesh.indices.empty()) continue;
        const mesh::Nearness surface(next.mesh);
        wood.coarser_m.clear();
        wood.coarser_sways.clear();
        std::uint32_t last = 0;  // vertices that follow one another are neighbours
        for (const glm::vec3& from_m : wood.mesh.positions_m) {
            const mesh::Nearness::Nearest on = surface.nearest(from_m, last, 0.3F);
            last = on.triangle;
            wood.coarser_m.push_back(on.at_m);
            wood.coarser_sways.push_back(between(next.mesh, next.sways, on));
        }
    }
}

}  // namespace quadrat::synthesis::trees
