// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::synthesis::noise {

// Tiles in a box of cells: x east, y south, z up. Each is a printable character; '.' is air.
struct Tiles {
    static constexpr char kAir = '.';
    glm::ivec3 size{0};
    std::string cells;  // x fastest, then y, then z

    // Around them there is air, and under them ground: kGround.
    static constexpr char kGround = '_';
    char at(glm::ivec3 cell) const;
    bool is_inside(glm::ivec3 cell) const;
    char& cell(glm::ivec3 at) { return cells[index(at)]; }
    std::size_t index(glm::ivec3 cell) const;
    friend bool operator==(const Tiles&, const Tiles&) = default;
};

inline constexpr int kMostTilesASide = 64;
inline constexpr std::size_t kMostKindsOfTiles = 31;  // besides the ground

// Layers from the ground up, divided by empty lines; within one, rows from north to south. Lines that begin with a
// semicolon are comments. Throws base::InputError naming the file, the line and the column: layers or rows of other
// sizes, none at all, too many, a character that cannot be printed, the ground's, a semicolon.
Tiles tiles_from(std::string_view text, const std::string& name);
std::string text_of(const Tiles& tiles);

// By how much likelier a kind is than the example has it.
struct Weight {
    char tile = Tiles::kAir;
    float times = 1;
};

// A box of that size in which nothing stands beside, over or under another that does not so in the example. Where the
// example has no such thing as air beside air or over the ground, those count as seen all the same, so that there
// always is such a box. Sizes are 1 to kMostTilesASide.
// parts: where not null, how many parts were made anew and how many came to nothing and stayed as they were.
struct Parts {
    int made = 0;
    int left = 0;
};
Tiles synthesise(const Tiles& example, glm::ivec3 size, const std::vector<Weight>& weights, base::Seed seed,
                 Parts* parts = nullptr);

// How many pairs of neighbours, those with what is around the box included, stand together so nowhere in the example.
int forbidden_neighbours(const Tiles& example, const Tiles& tiles);

}  // namespace quadrat::synthesis::noise
