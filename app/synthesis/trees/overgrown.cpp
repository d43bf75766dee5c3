// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/overgrown.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "synthesis/voxels/climber.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kLeaf_m = 0.42F;
constexpr float kRed = 0.15F;  // of trunks that bear climbers

// Whole blades of one, appended to another.
void append_blade(scene::Leaves& to, const scene::Leaves& from, std::size_t blade) {
    const std::size_t vertices = from.vertices.size() / from.blades;
    const auto first = static_cast<std::uint32_t>(blade * vertices);
    const auto moved = static_cast<std::uint32_t>(to.vertices.size());
    const auto begin = from.vertices.begin() + static_cast<std::ptrdiff_t>(first);
    to.vertices.insert(to.vertices.end(), begin, begin + static_cast<std::ptrdiff_t>(vertices));
    const auto copy = [&](const std::vector<std::uint32_t>& indices, std::size_t each, auto& into) {
        for (std::size_t k = blade * each; k < (blade + 1) * each; ++k) into.push_back(indices[k] - first + moved);
    };
    copy(from.indices, from.indices_per_blade(), to.indices);
    copy(from.plain_indices, from.indices_per_plain_blade(), to.plain_indices);
    ++to.blades;
}

}  // namespace

scene::Leaves climber_leaves(const scene::Wood& wood, float trunk_radius_m, float high_m, const LeafShape& shape,
                             std::size_t most, base::Seed seed) {
    const float cell_m = std::clamp(0.8F * trunk_radius_m, 0.12F, 0.3F);
    const float wide_m = 3 * trunk_radius_m + 0.6F;
    voxels::Surroundings around({-wide_m, -0.3F, -wide_m}, {wide_m, high_m + 1, wide_m}, cell_m);
    const auto& at = wood.mesh.positions_m;
    const auto& indices = wood.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        around.add_face(at[indices[i]], at[indices[i + 1]], at[indices[i + 2]], voxels::Surroundings::Kind::Hold);
    voxels::Climber climber;
    climber.high_m = high_m;
    climber.most = most;
    const std::array roots{glm::vec3{trunk_radius_m, 0.1F, 0}, glm::vec3{-trunk_radius_m, 0.1F, 0},
                           glm::vec3{0, 0.1F, trunk_radius_m}};
    const glm::vec3 colour = voxels::climber_colour(kRed, seed.child("colour"));
    scene::Leaves leaves;
    for (const voxels::Tendril& tendril : voxels::climb(around, roots, climber, seed.child("shoots"))) {
        base::RandomStream random{seed.child("leaves").child(leaves.blades)};
        const glm::vec3 chance{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        BladeShape blade;
        blade.site_m = tendril.at_m;
        blade.along = glm::normalize(0.7F * tendril.way + 0.5F * tendril.out + 0.6F * chance);
        const glm::vec3 face = tendril.out + glm::vec3{0, 0.5F, 0};
        blade.face = glm::normalize(face - glm::dot(face, blade.along) * blade.along + 1.0e-3F * chance);
        blade.length_m = kLeaf_m * random.between(0.8F, 1.3F);
        blade.half_width_m = 0.35F * blade.length_m;
        blade.fold_m = 0.2F * blade.half_width_m;
        scene::Leaves::Vertex vertex;
        vertex.normal = glm::normalize(tendril.out + glm::vec3{0, 0.3F, 0} + 0.2F * chance);
        vertex.colour = colour * random.between(0.8F, 1.25F);
        vertex.age = 0.6F + 0.35F * std::min(tendril.at_m.y / std::max(high_m, 0.1F), 1.0F);
        vertex.sway = 0.05F;
        vertex.shade = 0.8F;
        add_blade(leaves, shape, blade, vertex);
    }
    return leaves;
}

void mix_in(scene::Leaves& to, const scene::Leaves& others) {
    if (others.blades == 0) return;
    if (to.blades == 0) {
        to = others;
        return;
    }
    assert(to.indices_per_blade() == others.indices_per_blade());
    const std::size_t all = to.blades + others.blades;
    scene::Leaves mixed;
    mixed.are_sprays = to.are_sprays;
    mixed.vertices.reserve(to.vertices.size() + others.vertices.size());
    mixed.indices.reserve(to.indices.size() + others.indices.size());
    mixed.plain_indices.reserve(to.plain_indices.size() + others.plain_indices.size());
    for (std::size_t i = 0; i < all; ++i) {
        // Of the first i + 1 blades so many are of the others.
        const std::size_t due = (i + 1) * others.blades / all;
        const std::size_t done = i * others.blades / all;
        if (due > done)
            append_blade(mixed, others, done);
        else
            append_blade(mixed, to, i - done);
    }
    to = std::move(mixed);
}

}  // namespace quadrat::synthesis::trees
