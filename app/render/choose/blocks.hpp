// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "render/choose/frustum.hpp"
#include "render/choose/horizon.hpp"
#include "render/choose/reach.hpp"

namespace quadrat::render::choose {

// A square heightfield in square blocks, each drawn at a power of two of its cells. Where two levels meet, the finer
// block's border uses the coarser one's vertices only, so there are no cracks and nothing to hide them with. A vertex
// that the next coarser level leaves out has moved onto that level's triangle before it goes, by its own distance from
// the eye, so nothing jumps when a level changes.
class Blocks {
  public:
    // block_cells a power of two; made smaller until it divides the field. Nothing within hole_m of the middle is
    // drawn: blocks that lie in that square entirely.
    Blocks(const mesh::Field& height_m, float cell_m, int block_cells, float hole_half_side_m = 0);

    struct Wish {
        glm::vec3 eye_m;
        float pixels_per_radian;                    // of the view
        float error_px = 1.3F;                      // how far the ground may lie from its true height on the screen,
        std::size_t triangle_budget = 12'000;       // and further where this would not hold it
        float near_m = 0;                           // blocks that begin nearer than this are counted apart
        std::span<const std::uint8_t> hidden = {};  // a block: 1 where it is left out; none: all are there
        Reach reach = {};                           // of what is chosen for all of it, the part that is appended
    };
    struct Selected {
        std::size_t triangles = 0;
        std::size_t near_indices = 0;  // come first
        float error_px = 0;            // what the budget made of the wish
    };
    // Appends the triangles that frustum sees, nearest blocks first.
    Selected select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;
    // A block: 1 where frustum sees it but for nearer ground, however coarse that is drawn. Raises the horizon, which
    // is of the same eye and of nearer ground only.
    std::vector<std::uint8_t> hidden(const Frustum& frustum, glm::vec3 eye_m, Horizon& horizon) const;

    // 0 finest. A block's error at a level is the farthest that any sample of it lies from the triangles drawn, and at
    // least twice that of the finer one: so one level's vertices have moved before many of the next one's begin to.
    int level_of(int block, const Wish& wish) const;
    float error_m(int block, int level) const { return errors_m_[entry(block, level)]; }
    int coarsest_level() const { return coarsest_; }
    int blocks_a_side() const { return side_; }

    // How a sample leaves the mesh.
    struct Leaving {
        float error_m = 0;  // it has moved onto the coarser level where that may lie so far from the truth; 0: it stays
        float coarser_m = 0;  // its height there
    };
    Leaving leaving(const mesh::Field& height_m, int column, int row) const;

    // From its own height, 0, to the coarser level's, 1: begins at this share of the way from the eye to where the
    // level may change. What shaders/common/grid.glsl does with the same numbers.
    static constexpr float kEaseFrom = 0.75F;
    static float eased(float distance_m, float error_m, const Wish& wish);

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
    std::vector<Near> seen_by(const Frustum& frustum, glm::vec3 eye_m, std::span<const std::uint8_t> hidden) const;
    float affordable_error_px(const std::vector<Near>& seen, Wish wish) const;
    std::size_t entry(int block, int level) const { return static_cast<std::size_t>(block * (coarsest_ + 1) + level); }
    void measure_row(const mesh::Field& height_m, int row);
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
    std::vector<Block> squares_;   // of kSquare blocks a side, row by row: out of sight, all of them are
    std::vector<float> errors_m_;  // a block and level
    mutable std::vector<std::vector<std::uint32_t>> patterns_;  // made when they are first asked for
};

// What a vertex's error is told in on the GPU: shaders/common/grid.glsl.
inline constexpr float kErrorUnit_m = 1.0F / 128;
// What the vertices of a selection are eased by there.
float ease_of(const Blocks::Wish& wish, float error_px);

}  // namespace quadrat::render::choose
