// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/seed.hpp"
#include "synthesis/trees/lsystem.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

struct TurtleOptions {
    float internode_m = 2;        // length of F(1)
    float trunk_radius_m = 0.2F;  // of the first width that is set; others in proportion
    float least_radius_m = 0.01F;
    float width_ratio = 0.707F;  // of one generation to the one before, to tell generations from widths
    glm::vec3 tropism{0, 1, 0};  // direction limbs bend toward,
    float tropism_strength = 0;  // by so much an internode
    float gnarl_deg = 0;         // chance deviation an internode; keyed by its number
    int leafy_from = 8;          // generations that bear leaves
    int bare_from = 99;          // generations too thin to be limbs: only their leaves are kept
};

// Reads a word with a turtle in space (ABOP section 1.5): F(l) forward, !(w) width, +(a) -(a) turn, &(a) ^(a) pitch,
// /(a) \(a) roll, $ roll until left is level, [ ]. Other letters say nothing.
TreeSkeleton interpret(std::span<const Module> word, const TurtleOptions& options, base::Seed seed);

}  // namespace quadrat::synthesis::trees
