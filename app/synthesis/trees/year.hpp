// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "synthesis/trees/skeleton.hpp"

// A plant through a year. Its buds are an L-system with a table of productions each season (Rozenberg, "T0L systems and
// languages", 1973; Prusinkiewicz & Lindenmayer 1990, section 1.10): grammars/year.lsys. Limbs stay as they are.
namespace quadrat::synthesis::trees {

inline constexpr float kMidsummer = 1.0F / 3.0F;

struct Year {
    float season = kMidsummer;  // 0 spring, a third midsummer, two thirds autumn, 1 winter
    float sheds = 1;            // of its leaves, in winter: 0 evergreen to 1
    float flowers = 0;          // of its buds, in spring
};

// What stands where buds were, of so many buds that stand for all; Organ::None: not yet, or no more.
inline constexpr int kBuds = 512;
std::vector<Organ> organs_in(const Year& year);

// Gives a plant's sites what the year makes of them: leaves come, turn and fall; flowers and fruits have their time. Of
// no effect at midsummer. How many of its leaves are not there, 0 to 1.
float pass_year(TreeSkeleton& skeleton, const Year& year, base::Seed seed);

// What the season makes of plants that have no buds of their own, against midsummer.
struct Meadow {
    float dryness = 0;   // more of grass.dryness
    float height = 1;    // factor, of grass and herbs
    float flowers = 1;   // factor, of how many there are
    float withered = 0;  // of ferns and reeds: green to brown
};
Meadow meadow_in(float season);

}  // namespace quadrat::synthesis::trees
