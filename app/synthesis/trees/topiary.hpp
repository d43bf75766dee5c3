// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/skeleton.hpp"

// Plants that are clipped to a shape (Prusinkiewicz, James & Měch, "Synthetic topiary", SIGGRAPH 1994): a shoot that
// grows out of the shape is cut, and the cut wakes dormant buds below it, so that the plant fills what it is clipped
// to.
namespace quadrat::synthesis::trees {

enum class TopiaryShape { None, Cone, BallOnStem, Tiers, Obelisk };

// Whether a place lies within the shape, of height 1 on the ground.
bool is_within(TopiaryShape shape, const glm::vec3& at);

struct TopiaryOptions {
    TopiaryShape shape = TopiaryShape::Cone;
    float height_m = 1.8F;
    glm::vec3 leaf{0.05F, 0.1F, 0.03F};  // linear
    glm::vec3 bark{0.1F};
};
TreeSkeleton clipped_skeleton(const TopiaryOptions& options, base::Seed seed);
scene::Species topiary(const TopiaryOptions& options, base::Seed seed);  // of the shrubs; none grows wild

}  // namespace quadrat::synthesis::trees
