// SPDX-License-Identifier: Apache-2.0
#include "synthesis/lsystem/map_lsystem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "unit/synthesis/map_faults.hpp"

namespace {

using namespace quadrat;
using testing::HasSubstr;
using namespace quadrat::synthesis::lsystem;

const std::vector<glm::vec2> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Figure 7.3 of the book: A -> B[-A][+A]B, B -> A.
TEST(MapLsystem, DividesASquareAsTheBookDoes) {
    const MapGrammar grammar = library_map("map-cross");
    std::size_t cells = 1;
    for (int steps = 1; steps <= 7; ++steps) {
        const Map map = derive_map(grammar, kSquare, {.steps = steps}, base::Seed{1});
        cells *= 2;
        EXPECT_EQ(map.cells.size(), cells) << steps;
        for (std::size_t i = 0; i < map.cells.size(); ++i)
            EXPECT_NEAR(map.area(i), 1.0F / static_cast<float>(cells), 1.0e-5F);
    }
}

TEST(MapLsystem, CellsFillTheFirstOneAndEachWallHasOneOnEitherSide) {
    for (const NamedMap& one : map_library())
        for (const int pull : {0, 6}) {
            const Map map =
                derive_map(library_map(one.name), kSquare, {.steps = 7, .chance = 0.5F, .pull = pull}, base::Seed{3});
            EXPECT_GT(map.cells.size(), 8U) << one.name;
            EXPECT_EQ(tests::map_faults(map, 1), "") << one.name;
        }
}

// A grammar of up to four letters by chance, most of whose walls sprout.
std::string any_grammar(base::Seed seed) {
    base::RandomStream random{seed};
    const auto wall = [&] {
        const char* courses[] = {"", "", "<", ">"};
        return std::string(1, static_cast<char>('A' + random.below(4))) + courses[random.below(4)];
    };
    std::string text = "start:";
    for (std::uint32_t i = 3 + random.below(4); i > 0; --i) text += " " + wall();
    for (const char* predecessor : {"A", "B", "C", "D"}) {
        text += std::string("\n") + predecessor + " -> ";
        for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
            for (std::uint32_t k = random.below(3); k > 0; --k)
                text += (random.below(2) == 0 ? "[+" : "[-") + wall() + "]";
            text += wall();
        }
    }
    return text + "\n";
}

TEST(MapLsystem, OfAnyGrammarCellsAreClosedAndFillTheFirstAsEulerSays) {
    std::size_t most = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const std::string text = any_grammar(base::Seed{seed});
        const MapGrammar grammar = read_map_grammar(text, "any");
        const std::vector<glm::vec2> outline = regular_outline(grammar.start.size());
        const Map whole = derive_map(grammar, outline, {.steps = 0}, base::Seed{1});
        const Map map =
            derive_map(grammar, outline,
                       {.steps = 4, .chance = 0.2F * static_cast<float>(seed % 5), .pull = static_cast<int>(seed % 3)},
                       base::Seed{seed});
        ASSERT_EQ(tests::map_faults(map, whole.area(0)), "") << text;
        most = std::max(most, map.cells.size());
    }
    EXPECT_GE(most, 16U) << "they do divide";
}

// Only so can the tests above fail.
TEST(MapLsystem, AFaultIsFound) {
    const Map right = derive_map(library_map("map-cross"), kSquare, {.steps = 3}, base::Seed{1});
    ASSERT_EQ(tests::map_faults(right, 1), "");
    EXPECT_NE(tests::map_faults(right, 2), "") << "another area";
    Map wrong = right;
    wrong.cells.pop_back();
    EXPECT_NE(tests::map_faults(wrong, 1), "") << "a cell less";
    wrong = right;
    std::swap(wrong.cells.front()[0], wrong.cells.front()[1]);
    EXPECT_NE(tests::map_faults(wrong, 1), "") << "walls out of order";
    wrong = right;
    wrong.cells.push_back(wrong.cells.front());
    EXPECT_NE(tests::map_faults(wrong, 1), "") << "a cell twice";
}

TEST(MapLsystem, IsTheSameForASeed) {
    const MapOptions options{.steps = 6, .chance = 0.6F, .pull = 2};
    const auto corners = [&](std::uint64_t seed) {
        return derive_map(library_map("map-fields"), kSquare, options, base::Seed{seed}).corners;
    };
    EXPECT_EQ(corners(4), corners(4));
    EXPECT_NE(corners(4), corners(5));
}

TEST(MapLsystem, ACellDividesOnlyWhereTwoSproutsMatch) {
    const auto cells = [](const std::string& productions) {
        const MapGrammar grammar = read_map_grammar("map: m\nstart: A B A B\n" + productions, "m");
        return derive_map(grammar, kSquare, {.steps = 1}, base::Seed{1}).cells.size();
    };
    EXPECT_EQ(cells("A -> A[+C]A\n"), 2U);
    EXPECT_EQ(cells("A -> A[-C]A\n"), 1U) << "both sprout outward";
    EXPECT_EQ(cells("A -> A[+C>]A\n"), 1U) << "both lead away";
    EXPECT_EQ(cells("A -> A[+C>][+C<]A\n"), 2U) << "one leads away and one back";
    EXPECT_EQ(cells("A -> A[+C]A\nB -> B[+D]B\n"), 2U) << "one wall a step";
    EXPECT_EQ(cells("A -> A[+C]A[+C]A\n"), 2U) << "not with itself along its own wall";
    EXPECT_EQ(cells("B -> A\n"), 1U);
}

TEST(MapLsystem, LeavesSmallCellsWhole) {
    const Map map = derive_map(library_map("map-cross"), kSquare, {.steps = 12, .most_area = 0.04F}, base::Seed{1});
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        EXPECT_LE(map.area(i), 0.04F);
        EXPECT_GT(map.area(i), 0.019F);
    }
}

TEST(MapLsystem, WallsOfCellsThatStayWholeStayWhole) {
    const MapOptions options{.steps = 9, .most_area = 0.1F};
    const Map map = derive_map(library_map("map-cross"), kSquare, options, base::Seed{1});
    std::set<std::uint32_t> walls;
    for (const auto& cell : map.cells)
        for (const Map::Side& side : cell) walls.insert(side.wall);
    EXPECT_EQ(map.cells.size(), 16U);
    EXPECT_LE(walls.size(), 80U);
}

TEST(MapLsystem, WallsDrawThemselvesShort) {
    const auto length = [](int pull) {
        const Map map =
            derive_map(library_map("map-leaf"), kSquare, {.steps = 6, .chance = 0.6F, .pull = pull}, base::Seed{2});
        std::set<std::uint32_t> walls;
        for (const auto& cell : map.cells)
            for (const Map::Side& side : cell) walls.insert(side.wall);
        float sum = 0;
        for (const std::uint32_t wall : walls)
            sum += std::hypot(map.corners[map.walls[wall].to].x - map.corners[map.walls[wall].from].x,
                              map.corners[map.walls[wall].to].y - map.corners[map.walls[wall].from].y);
        return sum;
    };
    EXPECT_LT(length(8), length(0));
}

TEST(MapLsystem, IsRefusedByFileAndLine) {
    const auto error_of = [](const std::string& text) -> std::string {
        try {
            const MapGrammar grammar = read_map_grammar(text, "own.map");
            derive_map(grammar, kSquare, {.most_cells = 64}, base::Seed{1});
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(error_of("map: m\n"), HasSubstr("own.map:1:1: no start"));
    EXPECT_THAT(error_of("map: m\nstart: A B\n"), HasSubstr("own.map:2:11: a cell has three walls"));
    EXPECT_THAT(error_of("start: A A A A\nA -> [+B]\n"), HasSubstr("own.map:2:10: nothing is left"));
    EXPECT_THAT(error_of("start: A A A A\nA -> A[B]A\n"), HasSubstr("own.map:2:8: 'B' stands where a sprout's side"));
    EXPECT_THAT(error_of("start: A A A A\nA -> A[+B\n"), HasSubstr("own.map:2:10: the line's end stands where ]"));
    EXPECT_THAT(error_of("start: A A A A\nA -> a\n"), HasSubstr("own.map:2:6: 'a' stands where a wall should"));
    EXPECT_THAT(error_of("start: A A A A\nA -> A\nA -> B\n"), HasSubstr("own.map:3:3: there is a production of A"));
    EXPECT_THAT(error_of("start: A A A A\nAB -> A\n"), HasSubstr("own.map:2:2: 'B' stands where -> should"));
    EXPECT_THAT(error_of("start: A A A A\nsteps: many\n"), HasSubstr("own.map:2:12: steps: a whole number, 0 to 30"));
    EXPECT_THAT(error_of("start: A A A A\nsteps: 3 4\n"), HasSubstr("whole number"));
    EXPECT_THAT(error_of("start: A A A A\ncolour: red\n"), HasSubstr("own.map:2:1: 'c' stands where map:"));
    EXPECT_THAT(error_of("start: A B A\n"), HasSubstr("own.map: the first cell has 3 walls, and 4 corners"));
    EXPECT_THAT(error_of("start: A B A B\nsteps: 30\nA -> B[-A][+A]B\nB -> A\n"),
                HasSubstr("own.map: more than 64 cells"));
    EXPECT_THAT(error_of("start: A A A A\nsteps: 30\nA -> AAAA\n"), HasSubstr("own.map: more than 768 walls"));
    EXPECT_TRUE(is_map_grammar("# a comment\nmap: m\nstart: A A A\n"));
    EXPECT_FALSE(is_map_grammar("name: a tree\naxiom: F\n"));
}

}  // namespace
