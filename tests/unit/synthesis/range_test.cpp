// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/land_parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::synthesis {
namespace {

const scene::Fineness kCoarse{65, 64, 128};

struct Place {
    float out_m;
    float north_m;
};

Place place_of(const scene::Land& land, int column, int row) {
    const float half = 0.5F * static_cast<float>(land.surround_m.columns - 1);
    const float x = (static_cast<float>(column) - half) * land.surround_cell_m;
    const float z = (static_cast<float>(row) - half) * land.surround_cell_m;
    return {std::hypot(x, z), -z};
}

// Between 5 and 8 km, in the north; farther in it is only streams that run from it, and none near the land.
TEST(FarRange, StandsBehindTheFirstInTheNorthAlone) {
    scene::LandParameters p;
    p.erosion_strength = 0;
    p.range_far = 0;
    const scene::Land without = grow_land(p, base::Seed{3}, kCoarse);
    p.range_far = 1;
    const scene::Land with = grow_land(p, base::Seed{3}, kCoarse);
    EXPECT_EQ(with.height_m, without.height_m);
    float most_m = 0;
    for (int row = 0; row < with.surround_m.rows; ++row) {
        for (int column = 0; column < with.surround_m.columns; ++column) {
            const Place place = place_of(with, column, row);
            const float more_m = with.surround_m.at(column, row) - without.surround_m.at(column, row);
            if (place.out_m > 5000 && place.out_m < 8000 && place.north_m > 0) {
                most_m = std::max(most_m, more_m);
            } else if (place.out_m < 800) {
                ASSERT_EQ(more_m, 0) << column << " " << row;
            }
        }
    }
    EXPECT_GT(most_m, 100);
}

// The share of the land that is nearly white.
float snowy(const scene::LandParameters& p) {
    const scene::Land land = grow_land(p, base::Seed{5}, kCoarse);
    int white = 0;
    for (int y = 0; y < land.albedo.height(); ++y)
        for (int x = 0; x < land.albedo.width(); ++x) {
            const glm::u8vec3 c = land.albedo.colour(x, y);
            white += std::min({c.r, c.g, c.b}) > 200 ? 1 : 0;
        }
    return static_cast<float>(white) / static_cast<float>(land.albedo.width() * land.albedo.height());
}

TEST(Snow, LiesOnNothingSteeperThanItIsAllowedTo) {
    scene::LandParameters p;
    p.land_relief_m = 240;
    p.land_gain = 0.54F;
    p.ground_snow_line = 0.3F;
    p.ground_snow_slope = 1.2F;
    const float deep = snowy(p);
    p.ground_snow_slope = 0.45F;
    const float thin = snowy(p);
    EXPECT_GT(deep, 0.1F);
    EXPECT_LT(thin, deep);
}

}  // namespace
}  // namespace quadrat::synthesis
