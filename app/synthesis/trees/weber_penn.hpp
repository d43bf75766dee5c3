// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string_view>

#include "base/seed.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// The outline that the lengths of first-order limbs follow, from the lowest (0) to the top (1).
enum class Outline {
    Conical,
    Spherical,
    Hemispherical,
    Cylindrical,
    TaperedCylindrical,
    Flame,
    InverseConical,
    TendFlame
};

// Parameters of Weber & Penn, "Creation and rendering of realistic trees" (SIGGRAPH 1995), by their names there; angles
// in degrees, lengths as shares of the bearer's.
struct WeberPenn {
    struct Level {
        float down_angle = 45, down_angle_v = 0;
        float rotate = 140, rotate_v = 0;
        float branches = 20;
        float length = 0.4F, length_v = 0;
        float taper = 1;
        float seg_splits = 0, split_angle = 0, split_angle_v = 0;
        int curve_res = 5;
        float curve = 0, curve_back = 0, curve_v = 0;
    };
    std::string_view name;
    Outline shape = Outline::Spherical;
    float base_size = 0.2F;  // of the trunk that is bare
    int levels = 3;
    float ratio = 0.02F;  // trunk radius to length
    float ratio_power = 1.2F;
    int base_splits = 0;
    float attraction_up = 0;
    float leaves = 8;  // on each stem of the last level; on the trunk's top when there is but one level
    std::array<Level, 3> level;
};

enum class Preset { Palm, Fir, Cactus, Broadleaf, Willow, Poplar, Acacia, Birch, Elm, Pine, Cherry, Cypress };
const WeberPenn& weber_penn(Preset preset);

// A trunk of length 1. At most most_limbs: what would come after is left out.
TreeSkeleton grow_weber_penn(const WeberPenn& parameters, base::Seed seed, std::size_t most_limbs = 1600);

}  // namespace quadrat::synthesis::trees
