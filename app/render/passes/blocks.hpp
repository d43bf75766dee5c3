// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
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

    // The same in pieces: nothing may be selected before every row of blocks has been measured.
    struct Unmeasured {};
    Blocks(Unmeasured, int columns, float cell_m, int block_cells, float hole_half_side_m = 0);
    void measure_row(const mesh::Field& height_m, int row);

    struct Wish {
        glm::vec3 eye_m;
        float pixels_per_radian;               // of the view
        float error_px = 1.3F;                 // how far the ground may lie from its true height on the screen,
        std::size_t triangle_budget = 12'000;  // and further where this would not hold it
        float near_m = 0;                      // blocks that begin nearer than this are counted apart
    };
    struct Selected {
        std::size_t triangles = 0;
        std::size_t near_indices = 0;  // come first
    };
    // Appends the triangles that frustum sees, nearest blocks first.
    Selected select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;

    // 0 finest. A block's error at a level is the farthest that any sample of it lies from the triangles drawn.
    int level_of(int block, const Wish& wish) const;
    float error_m(int block, int level) const {
        return errors_m_[static_cast<std::size_t>(block * (coarsest_ + 1) + level)];
    }
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
    struct Near {
        float distance_m;
        int block;
    };
    static constexpr int kSquare = 4;
    std::vector<Near> seen_by(const Frustum& frustum, glm::vec3 eye_m) const;
    float affordable_error_px(const std::vector<Near>& seen, Wish wish) const;
    void bound_squares(int row);
    const std::vector<std::uint32_t>& offsets_of(const Pattern& pattern) const;
    std::vector<std::uint32_t> make_offsets(const Pattern& pattern) const;
    int level_at(int block, float distance_m, const Wish& wish) const;
    float distance_to(const Block& block, glm::vec3 eye_m) const;
    Block bounded(const mesh::Field& height_m, int column, int row) const;
    float farthest_off_m(const mesh::Field& height_m, int column, int row, int level) const;

    int columns_;
    float cell_m_;
    int cells_;  // of a block
    int side_;   // blocks
    int coarsest_;
    float hole_half_side_m_;
    std::vector<Block> blocks_;
    std::vector<Block> squares_;  // of kSquare blocks a side, row by row: out of sight, all of them are
    std::vector<float> errors_m_;  // a block and level
    mutable std::vector<std::vector<std::uint32_t>> patterns_;  // made when they are first asked for
};

}  // namespace quadrat::render::passes
