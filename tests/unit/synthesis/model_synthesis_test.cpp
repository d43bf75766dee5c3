// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/model_synthesis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "base/error.hpp"
#include "synthesis/land/tile_examples.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using noise::Tiles;

Tiles example(std::string_view name) {
    for (const land::TileExample& one : land::tile_examples())
        if (one.name == name) return noise::tiles_from(one.text, std::string(name));
    return {};
}

TEST(ModelSynthesis, HasNoNeighboursThatTheExampleHasNot) {
    for (const land::TileExample& one : land::tile_examples()) {
        const Tiles of = noise::tiles_from(one.text, std::string(one.name));
        EXPECT_EQ(noise::forbidden_neighbours(of, of), 0) << "the example itself";
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            const Tiles made = noise::synthesise(of, {13, 11, 4}, {}, base::Seed{seed});
            ASSERT_EQ(noise::forbidden_neighbours(of, made), 0) << one.name << ' ' << seed << '\n'
                                                                << noise::text_of(made);
        }
    }
}

// Only so can the test above fail.
TEST(ModelSynthesis, AForbiddenNeighbourIsCounted) {
    const Tiles of = example("ruin");
    Tiles made = noise::synthesise(of, {9, 9, 3}, {}, base::Seed{1});
    for (char& cell : made.cells) cell = Tiles::kAir;
    EXPECT_EQ(noise::forbidden_neighbours(of, made), 0) << "air alone is right";
    made.cell({4, 4, 2}) = '#';
    EXPECT_EQ(noise::forbidden_neighbours(of, made), 6) << "what the example has not at all";
    made.cell({4, 4, 2}) = '-';
    EXPECT_GT(noise::forbidden_neighbours(of, made), 0) << "a wall in the air";
}

TEST(ModelSynthesis, FillsTheBoxAndUsesWhatTheExampleHas) {
    for (const land::TileExample& one : land::tile_examples()) {
        const Tiles of = noise::tiles_from(one.text, std::string(one.name));
        std::set<char> kinds;
        int solid = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const Tiles made = noise::synthesise(of, {13, 11, 4}, land::weights_of(one, 0.5F), base::Seed{seed});
            kinds.insert(made.cells.begin(), made.cells.end());
            solid += static_cast<int>(std::ranges::count_if(made.cells, [](char c) { return c != Tiles::kAir; }));
        }
        EXPECT_EQ(kinds, std::set<char>(of.cells.begin(), of.cells.end())) << one.name;
        EXPECT_GT(solid, 40 * 40) << one.name;
    }
}

// Of terraces: what has anything over it has rock on all sides, so that they rise in steps.
TEST(ModelSynthesis, TerracesAreSteps) {
    const Tiles of = example("terraces");
    const Tiles made = noise::synthesise(of, {14, 11, 4}, {{'.', 0.1F}, {'#', 5}}, base::Seed{2});
    int steps = 0;
    for (int z = 0; z + 1 < made.size.z; ++z)
        for (int y = 0; y < made.size.y; ++y)
            for (int x = 0; x < made.size.x; ++x) {
                if (made.at({x, y, z + 1}) == Tiles::kAir) continue;
                ++steps;
                for (const glm::ivec3 beside : {glm::ivec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}})
                    EXPECT_NE(made.at(glm::ivec3{x, y, z} + beside), Tiles::kAir);
            }
    EXPECT_GT(steps, 20);
}

TEST(ModelSynthesis, IsTheSameForASeedAndLeansAsItIsWeighed) {
    const Tiles of = example("ruin");
    EXPECT_EQ(noise::synthesise(of, {10, 10, 3}, {}, base::Seed{4}),
              noise::synthesise(of, {10, 10, 3}, {}, base::Seed{4}));
    int fallen = 0;
    int standing = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const auto walls = [&](float times) {
            const Tiles made = noise::synthesise(
                of, {12, 10, 4}, {{'-', times}, {'|', times}, {'7', times}, {'A', times}}, base::Seed{seed});
            return static_cast<int>(
                std::ranges::count_if(made.cells, [](char c) { return c == '-' || c == '|' || c == '7' || c == 'A'; }));
        };
        fallen += walls(0.05F);
        standing += walls(8);
    }
    EXPECT_GT(standing, 3 * fallen);
}

// Walls that have to close: where much is asked for, what was chosen first now and then leaves nothing for the rest.
TEST(ModelSynthesis, APartThatComesToNothingStaysAsItWas) {
    const Tiles of = example("ruin");
    noise::Parts all;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        noise::Parts parts;
        const Tiles made = noise::synthesise(of, {14, 11, 4}, {{'.', 0.001F}, {'o', 0.01F}, {'7', 40}, {'3', 40}},
                                             base::Seed{seed}, &parts);
        ASSERT_EQ(noise::forbidden_neighbours(of, made), 0) << noise::text_of(made);
        all.made += parts.made;
        all.left += parts.left;
    }
    EXPECT_GT(all.left, 0) << "none met a contradiction";
    EXPECT_GT(all.made, all.left);
}

TEST(ModelSynthesis, GoesRoundAnExampleOfOneTile) {
    const Tiles of = noise::tiles_from("###\n###\n", "one");
    const Tiles made = noise::synthesise(of, {5, 5, 2}, {}, base::Seed{2});
    EXPECT_EQ(noise::forbidden_neighbours(of, made), 0);
}

TEST(Tiles, AreReadAndWrittenLayerByLayer) {
    const std::string text = "ab\ncd\n\n..\n.#\n";
    const Tiles tiles = noise::tiles_from("; two layers\n" + text, "t");
    EXPECT_EQ(tiles.size, glm::ivec3(2, 2, 2));
    EXPECT_EQ(tiles.at({1, 0, 0}), 'b');
    EXPECT_EQ(tiles.at({1, 1, 1}), '#');
    EXPECT_EQ(tiles.at({2, 1, 1}), Tiles::kAir);
    EXPECT_EQ(tiles.at({0, 0, -1}), Tiles::kGround);
    EXPECT_EQ(noise::text_of(tiles), text);
    EXPECT_EQ(noise::tiles_from("ab\r\ncd\r\n", "t").size, glm::ivec3(2, 2, 1));
}

TEST(Tiles, AreRefusedByFileAndLine) {
    const auto error_of = [](const std::string& text) -> std::string {
        try {
            noise::tiles_from(text, "own.tiles");
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(error_of("").find("own.tiles:1:1: no tiles"), std::string::npos) << error_of("");
    EXPECT_NE(error_of("ab\nabc\n").find("own.tiles:2:4: a row of 3"), std::string::npos);
    EXPECT_NE(error_of("ab\nab\n\nab\n").find("1 rows"), std::string::npos) << error_of("ab\nab\n\nab\n");
    EXPECT_NE(error_of("a b\n").find("printable"), std::string::npos);
    EXPECT_NE(error_of("a;\n").find("semicolon"), std::string::npos);
    EXPECT_NE(error_of("a_\n").find("underscore"), std::string::npos);
    std::string wide(65, 'a');
    wide.push_back('\n');
    EXPECT_NE(error_of(wide).find("64"), std::string::npos);
    std::string many;
    for (char c = '<'; c < '<' + 35; ++c) many.push_back(c);
    EXPECT_NE(error_of(many + "\n").find("31 kinds"), std::string::npos) << error_of(many + "\n");
}

TEST(TileShapes, FaceOutwardAndStayAboutTheirTiles) {
    for (const char tile : std::string("-|AH7913weNSoc,r#")) {
        const Tiles one{{1, 1, 1}, std::string(1, tile)};
        const auto facets = land::facets_of(one, {2, 2, 0.5F}, base::Seed{3});
        ASSERT_TRUE(tile == ',' || !facets.empty()) << tile;
        // Of the facets that look up or sideways most are seen from outside: the sum over them of how far a facet lies
        // out the way it faces is a volume, and more than nothing.
        double volume = 0;
        for (const land::TileFacet& f : facets) {
            for (const glm::vec3& corner : f.corners) {
                ASSERT_LE(std::max(std::abs(corner.x), std::abs(corner.z)), 1.2F) << tile;
                ASSERT_GE(corner.y, -0.51F) << tile;
                ASSERT_LE(corner.y, 2.1F) << tile;
            }
            volume += static_cast<double>(glm::dot(f.corners[0], glm::cross(f.corners[1], f.corners[2]))) / 6;
        }
        EXPECT_TRUE(facets.empty() || volume > 0) << tile;
    }
}

}  // namespace
