// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <vector>

#include "mesh/field.hpp"
#include "render/passes/frustum.hpp"

namespace quadrat::render::passes {

// A square heightfield in square blocks, each drawn at a power of two of its cells. Where two levels meet, the finer
// block's border uses the coarser one's vertices only, so there are no cracks and nothing to hide them with.
class Blocks {
  public:
    // block_cells a power of two; made smaller until it divides the field. Nothing within hole_m of the middle is
    // drawn: blocks that lie in that square entirely.
    Blocks(const mesh::Field& height_m, float cell_m, int block_cells, float hole_half_side_m = 0);

    struct Wish {
        glm::vec3 eye_m;
        float pixels_per_radian;  // of the view
        float cell_px = 14;       // about how large a cell may look
    };
    // Appends the triangles that frustum sees, nearest blocks first; returns how many.
    std::size_t select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;

    int level_at(float distance_m, const Wish& wish) const;  // 0 finest
    int coarsest_level() const { return coarsest_; }
    int blocks_a_side() const { return side_; }

  private:
    struct Block {
        glm::vec3 low_m;
        glm::vec3 high_m;
        bool is_drawn = true;
    };
    // A block's level, then its neighbours' toward north, east, south, west where they are coarser.
    using Pattern = std::array<int, 5>;
    const std::vector<std::uint32_t>& offsets_of(const Pattern& pattern) const;
    std::vector<std::uint32_t> make_offsets(const Pattern& pattern) const;
    float distance_to(const Block& block, glm::vec3 eye_m) const;

    int columns_;
    float cell_m_;
    int cells_;  // of a block
    int side_;   // blocks
    int coarsest_;
    std::vector<Block> blocks_;
    mutable std::map<Pattern, std::vector<std::uint32_t>> patterns_;
};

}  // namespace quadrat::render::passes
