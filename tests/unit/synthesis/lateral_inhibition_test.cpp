// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/lateral_inhibition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/land/ground.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

struct Apart {
    float least = 1.0e9F;
    float mean = 0;
};

Apart nearest_of(const std::vector<glm::ivec2>& peaks, int side) {
    Apart apart;
    for (const glm::ivec2 p : peaks) {
        float nearest = 1.0e9F;
        for (const glm::ivec2 q : peaks) {
            if (p == q) continue;
            const int dx = std::abs(p.x - q.x);
            const int dy = std::abs(p.y - q.y);
            nearest = std::min(nearest, std::hypot(static_cast<float>(std::min(dx, side - dx)),
                                                   static_cast<float>(std::min(dy, side - dy))));
        }
        apart.least = std::min(apart.least, nearest);
        apart.mean += nearest / static_cast<float>(peaks.size());
    }
    return apart;
}

// Clark & Evans, 1954: the mean distance to the nearest to that of as many strewn by chance; 1 by chance, 2.15 at most.
TEST(LateralInhibition, SetsPeaksApartAsNoChanceDoes) {
    constexpr int kSide = 64;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const auto peaks = noise::peaks_of(noise::inhibited({}, base::Seed{seed}, kSide));
        ASSERT_GT(peaks.size(), 60U) << seed;
        const Apart apart = nearest_of(peaks, kSide);
        EXPECT_GT(apart.least, 0.3F * noise::kPeakSpacing) << seed;
        const float by_chance = 0.5F * kSide / std::sqrt(static_cast<float>(peaks.size()));
        EXPECT_GT(apart.mean / by_chance, 1.5F) << seed;
        std::vector<glm::ivec2> strewn;
        base::RandomStream random{base::Seed{seed}};
        for (std::size_t i = 0; i < peaks.size(); ++i)
            strewn.emplace_back(static_cast<int>(random.below(kSide)), static_cast<int>(random.below(kSide)));
        EXPECT_LT(nearest_of(strewn, kSide).mean / by_chance, 1.3F) << "only so can it fail";
    }
}

TEST(LateralInhibition, GrowsOutOfNearlyNothingAndStands) {
    const mesh::Field early = noise::inhibited({.steps = 20}, base::Seed{3}, 48);
    const mesh::Field late = noise::inhibited({.steps = 900}, base::Seed{3}, 48);
    const mesh::Field later = noise::inhibited({.steps = 1100}, base::Seed{3}, 48);
    EXPECT_LT(*std::ranges::max_element(early.samples), 1.6F);
    EXPECT_GT(*std::ranges::max_element(late.samples), 2.5F);
    double moved = 0;
    for (std::size_t i = 0; i < late.samples.size(); ++i)
        moved += std::abs(late.samples[i] - later.samples[i]) / static_cast<double>(late.samples.size());
    EXPECT_LT(moved, 0.1);
}

TEST(LateralInhibition, RanksAreEvenWhateverTheField) {
    const mesh::Field ranks = noise::ranks_of(noise::inhibited({}, base::Seed{3}, 32));
    const auto below = std::ranges::count_if(ranks.samples, [](float r) { return r < 0.25F; });
    EXPECT_EQ(below, 32 * 32 / 4);
    EXPECT_GT(*std::ranges::min_element(ranks.samples), 0);
    EXPECT_LT(*std::ranges::max_element(ranks.samples), 1);
}

// Of cracked mud: how much of a tile lies in cracks, far below the rest.
TEST(CrackedMud, HasCracksRoundPlatesAndRepeats) {
    const mesh::Field mud = land::mud_tile(base::Seed{2}, 128);
    const auto is_crack = [&](int x, int y) { return mud.at((x + 128) % 128, (y + 128) % 128) < -1.0F; };
    int cracks = 0;
    int joined = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            if (!is_crack(x, y)) continue;
            ++cracks;
            int beside = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) beside += is_crack(x + dx, y + dy);
            joined += beside >= 3;  // itself and two more: a line goes on, over the tile's edge too
        }
    EXPECT_GT(cracks, 128 * 128 / 25);
    EXPECT_LT(cracks, 128 * 128 / 3);
    EXPECT_GT(joined, 9 * cracks / 10);
}

}  // namespace
