// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bitset>

#include "base/seed.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// What symbols without a number mean, and what wind and weather add to the word.
struct TurtleOptions {
    float length = 1;  // of F
    float angle_deg = 90;
    float width = 1;  // at the root, in the unit of !(w)
    float width_ratio = 0.707F;
    float radius_per_width = 0.5F;
    float least_radius_m = 1.0e-3F;
    glm::vec3 tropism{0, 1, 0};  // limbs bend toward it,
    float elasticity = 0;        // by so much an internode (ABOP section 2.1)
    float gnarl_deg = 0;         // chance deviation an internode; keyed by its number
    float bare_below = 0;        // widths under this share of the root's are no limbs: only their leaves are kept
    float leafy_below = 0;       // internodes of a width under this share of the root's bear leaves
    std::size_t most_limbs = 20'000;
    std::bitset<256> no_organs;  // letters that draw no leaf and no flower: they only stand for what they become
};
// Letters that have productions draw no organs, but those that the grammar names under organs:.
TurtleOptions options_of(const Grammar& grammar);

// Reads a word with a turtle in space (ABOP section 1.5): F forward and draw, f forward, + - turn, & ^ pitch, / \ roll,
// | turn back, $ roll until left is level, ! width, L or ~ a leaf, K a flower, [ ]. Other letters say nothing, and so
// do L, ~ and K among no_organs.
TreeSkeleton interpret(const Word& word, const TurtleOptions& options, base::Seed seed);

}  // namespace quadrat::synthesis::trees
