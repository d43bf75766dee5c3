// SPDX-License-Identifier: Apache-2.0
#include "mesh/progressive.hpp"

#include <algorithm>

#include "mesh/collapsing_mesh.hpp"

namespace quadrat::mesh {

Progressive make_progressive(const Mesh& mesh, const ProgressiveOptions& options) {
    Progressive progressive;
    CollapsingMesh collapsing(mesh, options);
    std::vector<std::uint32_t> parents;
    progressive.levels.push_back(collapsing.level(parents));
    if (collapsing.vertex_count() == 0) return progressive;
    // The last is the one that comes nearest to the fewest, as a ratio.
    progressive.end = Progressive::End::Reached;
    while (2 * collapsing.vertex_count() * collapsing.vertex_count() > 4 * options.fewest * options.fewest) {
        const std::size_t before = collapsing.vertex_count();
        const bool is_whole = collapsing.collapse_until((before + 1) / 2);
        if (!is_whole) progressive.end = Progressive::End::AllAreRigid;
        if (collapsing.vertex_count() == before) break;
        Progressive::Level next = collapsing.level(parents);
        progressive.levels.back().parents = std::move(parents);
        progressive.levels.push_back(std::move(next));
        parents = {};
        if (!is_whole) break;
    }
    return progressive;
}

std::vector<glm::vec3> morph_targets_m(const Progressive& progressive, std::size_t level) {
    const Progressive::Level& fine = progressive.levels[level];
    if (fine.parents.empty()) return fine.mesh.positions_m;
    const auto& coarse = progressive.levels[level + 1].mesh.positions_m;
    std::vector<glm::vec3> targets;
    targets.reserve(fine.parents.size());
    for (const std::uint32_t parent : fine.parents) targets.push_back(coarse[parent]);
    return targets;
}

float ideal_distance_m(const Progressive::Level& level, float alpha) {
    constexpr float kBeta = 1;
    return alpha * std::pow(level.error_m, kBeta);
}

float level_at(const Progressive& progressive, float distance_m, float alpha) {
    const auto& levels = progressive.levels;
    std::size_t fine = 0;
    while (fine + 1 < levels.size() && ideal_distance_m(levels[fine + 1], alpha) <= distance_m) ++fine;
    if (fine + 1 >= levels.size()) return static_cast<float>(fine);
    const float near_m = ideal_distance_m(levels[fine], alpha);
    const float far_m = ideal_distance_m(levels[fine + 1], alpha);
    return static_cast<float>(fine) + std::clamp((distance_m - near_m) / (far_m - near_m), 0.0F, 1.0F);
}

}  // namespace quadrat::mesh
