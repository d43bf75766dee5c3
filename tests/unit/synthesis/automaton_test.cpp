// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/automaton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string_view>

namespace quadrat::synthesis::noise {
namespace {

using Cells = mesh::Grid<std::uint8_t>;

Cells cells_of(std::initializer_list<std::string_view> rows, int side) {
    Cells cells(side, side);
    int row = 4;
    for (const std::string_view line : rows) {
        for (std::size_t i = 0; i < line.size(); ++i) cells.at(static_cast<int>(i) + 2, row) = line[i] == 'O' ? 1 : 0;
        ++row;
    }
    return cells;
}

int alive(const Cells& cells) { return std::accumulate(cells.samples.begin(), cells.samples.end(), 0); }

// Gosper's gun, the classic figure: every thirty generations it is as it was, and one glider has left it.
TEST(Automaton, RunsTheGliderGun) {
    Cells cells = cells_of({"........................O",             //
                            "......................O.O",             //
                            "............OO......OO............OO",  //
                            "...........O...O....OO............OO",  //
                            "OO........O.....O...OO",                //
                            "OO........O...O.OO....O.O",             //
                            "..........O.....O.......O",             //
                            "...........O...O",                      //
                            "............OO"},
                           90);
    const Cells gun = cells;
    ASSERT_EQ(alive(gun), 36);
    for (int gliders = 1; gliders <= 4; ++gliders) {
        for (int i = 0; i < 30; ++i) cells = lived(cells);
        EXPECT_EQ(alive(cells), 36 + 5 * gliders);
        for (int row = 0; row < 13; ++row)
            for (int column = 0; column < 40; ++column)
                if (row < 9 || column < 20) {
                    EXPECT_EQ(cells.at(column, row), gun.at(column, row)) << column << " " << row;
                }
    }
}

TEST(Automaton, LeavesABlockAndTurnsABlinker) {
    const Cells block = cells_of({"OO", "OO"}, 12);
    EXPECT_EQ(lived(block), block);
    const Cells blinker = cells_of({".O.", ".O.", ".O."}, 12);
    EXPECT_EQ(lived(blinker), cells_of({"...", "OOO", "..."}, 12));
    EXPECT_EQ(lived(lived(blinker)), blinker);
}

float share(const mesh::Field& ages, float low, float high) {
    const auto count = std::ranges::count_if(ages.samples, [&](float age) { return age >= low && age < high; });
    return static_cast<float>(count) / static_cast<float>(ages.samples.size());
}

TEST(Forest, IsOldWhereItNeverBurns) { EXPECT_EQ(share(forest_ages(40, 0, base::Seed{1}), 1, 2), 1); }

TEST(Forest, HasPatchesOfSeveralAgesWhereItBurnsAndReturns) {
    const mesh::Field ages = forest_ages(56, 0.6F, base::Seed{3});
    EXPECT_GT(share(ages, 0, 0.34F), 0.08F);
    EXPECT_GT(share(ages, 0.34F, 0.67F), 0.05F);
    EXPECT_GT(share(ages, 0.9F, 2), 0.2F);
    EXPECT_LT(share(ages, 0, 0.02F), 0.4F) << "what has burnt comes back";
    // Neighbours are of an age: patches, not noise.
    double apart = 0;
    double anywhere = 0;
    for (int row = 0; row < 56; ++row)
        for (int column = 1; column < 56; ++column) {
            apart += std::abs(ages.at(column, row) - ages.at(column - 1, row));
            anywhere += std::abs(ages.at(column, row) - ages.at((column * 31 + 17) % 56, (row * 23 + 5) % 56));
        }
    EXPECT_LT(apart, 0.4 * anywhere);
    EXPECT_EQ(ages, forest_ages(56, 0.6F, base::Seed{3}));
}

TEST(Forest, IsYoungerTheMoreOftenItBurns) {
    double before = 2;
    for (const float fires : {0.0F, 0.3F, 1.0F}) {
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed)
            for (const float age : forest_ages(48, fires, base::Seed{seed}).samples) sum += age / (4 * 48 * 48);
        EXPECT_LT(sum, before - 0.05);
        before = sum;
    }
}

}  // namespace
}  // namespace quadrat::synthesis::noise
