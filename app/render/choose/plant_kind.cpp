// SPDX-License-Identifier: Apache-2.0
#include "render/choose/plant_kind.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/choose/closeness.hpp"

namespace quadrat::render::choose {
namespace {

constexpr std::size_t kCopies = 6;  // of leaves that hang on a twig
static_assert(kLeastBlade * kLeastBlade * kCopies >= 1, "a byte holds how small the most copies are");

// Of leaves among the first, which are as good as any: in the mean, but without what is much shorter, as blossoms are.
// A plain form has no twig.
float blade_length(const scene::Species& species) {
    constexpr std::size_t kLookedAt = 24;
    constexpr float kOwnTips = 1.15F;  // a spray reaches so much farther than its plain form
    const scene::Leaves& leaves = species.leaves;
    const bool has_plain = !leaves.plain_indices.empty();
    const std::vector<std::uint32_t>& indices = has_plain ? leaves.plain_indices : leaves.indices;
    const std::size_t a_blade = has_plain ? leaves.indices_per_plain_blade() : leaves.indices_per_blade();
    std::vector<float> lengths_m{1e-3F};
    for (std::size_t blade = 0; blade < std::min(leaves.blades, kLookedAt); ++blade) {
        lengths_m.push_back(1e-3F);
        for (std::size_t i = blade * a_blade; i < (blade + 1) * a_blade; ++i)
            lengths_m.back() = std::max(lengths_m.back(), glm::length(leaves.vertices[indices[i]].corner_m));
    }
    const float least_m = 0.6F * *std::ranges::max_element(lengths_m);
    float sum_m = 0;
    float count = 0;
    for (const float length_m : lengths_m) {
        if (length_m < least_m) continue;
        sum_m += length_m;
        ++count;
    }
    return (has_plain ? kOwnTips : 1.0F) * sum_m / count;
}

float reach_of(const scene::Species& species) {
    float reach = species.crown_radius_m;
    for (const scene::Wood& wood : species.wood)
        for (const glm::vec3& p : wood.mesh.positions_m) reach = std::max(reach, std::hypot(p.x, p.z));
    return reach;
}

// A blade as long as its crown is wide would be seen as what it is.
float largest_blade(const scene::Species& species) {
    const float share = species.masses.empty() ? 0.55F : 0.42F;  // the mass fills in
    return std::max(share * species.crown_radius_m / blade_length(species), 1.0F);
}

// Of a crown of leaves that lie by chance (Beer's law over the leaf area that stands before one, seen from aside), but
// for the gaps that twigs leave between them.
float opacity_of(const scene::Species& species) {
    const float crown_m2 = 0.785F * 2 * species.crown_radius_m * 0.7F * species.height_m;
    constexpr float kTurned = 0.5F;  // of a leaf's area, seen from anywhere
    constexpr float kMost = 0.85F;
    return kMost * (1 - std::exp(-kTurned * scene::area_m2(species.leaves) / std::max(crown_m2, 1e-3F)));
}

// What stands for it far away is strokes about nothing.
bool is_leafless(const scene::Species& species) {
    return !species.masses.empty() && species.masses.front().sprays == species.masses.front().mesh.triangle_count();
}

}  // namespace

PlantKind plant_kind_of(const scene::Species& species) {
    PlantKind kind;
    kind.height_m = species.height_m;
    kind.radius_m = reach_of(species);
    kind.crown_m = species.crown_radius_m;
    kind.opacity = opacity_of(species);
    kind.trunk_m = species.trunk_radius_m;
    for (const scene::Wood& wood : species.wood) {
        kind.wood_triangles.push_back(wood.mesh.triangle_count());
        kind.wood_left_out_m.push_back(wood.left_out_m);
    }
    kind.blades = species.leaves.blades;
    kind.triangles_per_blade = species.leaves.indices_per_blade() / 3;
    kind.triangles_per_plain_blade = species.leaves.indices_per_plain_blade() / 3;
    kind.blade_m = blade_length(species);
    if (species.leaves.are_sprays) kind.copies = kCopies;
    kind.are_slivers = is_leafless(species);
    kind.largest_blade = largest_blade(species);
    if (!species.masses.empty()) kind.massed = species.masses.front().share;
    for (const scene::CrownMass& mass : species.masses) kind.mass_triangles.push_back(mass.mesh.triangle_count());
    return kind;
}

}  // namespace quadrat::render::choose
