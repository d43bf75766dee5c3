// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/seed.hpp"
#include "synthesis/trees/skeleton.hpp"
#include "synthesis/voxels/shadow_grid.hpp"

namespace quadrat::synthesis::trees {

// Trees that organise themselves: buds compete for light and for what their tree makes of it (Palubicki et al. 2009;
// Měch & Prusinkiewicz 1996). Lengths in internodes; a year is a round of growth.
struct SelfOrganisation {
    int years = 20;  // 1 to 60
    float apical_young =
        0.55F;  // λ of the extended Borchert-Honda model, 0 to 1: what a leader gets before its laterals
    float apical_old = 0.47F;
    float vigour = 2.2F;  // α: internodes that the light of one bud makes in a year
    voxels::ShadowGrid::Shade shade{};
    float shedding = 0.12F;  // a limb falls that gets less light than this an internode
    float branch_angle_deg = 50;
    float divergence_deg = 137.5F;
    int laterals = 1;              // at a node: 1 to 5
    float flatness = 0;            // 0 to 1: laterals of limbs lie to the left and right, as a beech's
    float light_seeking = 0.3F;    // ξ
    float trunk_rise = 0.3F;       // η of the trunk, upward; less than 0: downward
    float limb_rise = 0;           // and of its limbs
    float gnarl = 0.08F;           // chance in each internode's direction
    int bare_internodes = 4;       // of the trunk, from below
    int longest_shoot = 5;         // internodes a year
    int bud_life = 4;              // years that a bud waits
    std::size_t most_buds = 5000;  // of one tree
    glm::vec3 upwind{0};           // where the wind comes from, times 0 to 1: it kills the buds that face it
    float apart = 16;              // of trees in a stand
};

// Where a seed falls, and where to it grows first.
struct Seedling {
    glm::vec2 at{0};
    glm::vec2 lean{0};  // tangent of the lean
};

// Trees that grow together, one a seedling and in their order, each rooted at its own origin. Lengths in internodes,
// radii by the pipe model's count alone. Seedlings no farther than 60 from one another's middle.
std::vector<TreeSkeleton> grow_together(const SelfOrganisation& parameters, std::span<const Seedling> seedlings,
                                        base::Seed seed);

// 5 by 5 seedlings so far apart, row by row; none quite in its place.
inline constexpr int kStandSide = 5;
std::vector<Seedling> stand_of_seedlings(float apart, base::Seed seed);

}  // namespace quadrat::synthesis::trees
