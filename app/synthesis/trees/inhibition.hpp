// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

namespace quadrat::synthesis::trees {

// A young leaf on a shoot: where it stands around it, and how far below the one that came last, in the shoot's radii.
struct Primordium {
    float turn_rad = 0;
    float below = 0;
};

// Leaves as they come, each keeping others off. Gamma is how far, in the shoot's radii: from kLeastInhibition, where
// they stand in whorls, over pairs and spirals (137.5° about 1.75) to kMostInhibition, where they stand in two rows.
// Oldest first; what comes of the seedling's own symmetry is left out. The same for the same numbers.
inline constexpr float kLeastInhibition = 0.72F;
inline constexpr float kMostInhibition = 2.4F;
std::vector<Primordium> leaves_of_shoot(float gamma, int count);

// Gamma by a share of that range, 0 to 1.
float inhibition_of(float share);

}  // namespace quadrat::synthesis::trees
