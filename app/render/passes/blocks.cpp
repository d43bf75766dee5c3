// SPDX-License-Identifier: Apache-2.0
// Blocks in powers of two, after Vlietinck's vertex-program terrain as described in "Genetic selection of parametric
// scenes" (2003), section 6.1. Ours differ: the level follows the block's own roughness as well as its depth, and
// borders are stitched by index instead of by a transition tiling.
#include "render/passes/blocks.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace quadrat::render::passes {
namespace {

int largest_block(int cells, int wanted) {
    while (wanted > 1 && cells % wanted != 0) wanted /= 2;
    return std::max(wanted, 1);
}

}  // namespace

Blocks::Blocks(const mesh::Field& height_m, float cell_m, int block_cells, float hole_half_side_m)
    : columns_(height_m.columns),
      cell_m_(cell_m),
      cells_(largest_block(height_m.columns - 1, block_cells)),
      side_((height_m.columns - 1) / cells_),
      coarsest_(std::bit_width(static_cast<unsigned>(cells_)) - 1) {
    assert(height_m.columns == height_m.rows && height_m.columns >= 2);
    for (int row = 0; row < side_; ++row) {
        for (int column = 0; column < side_; ++column) {
            Block block = bounded(height_m, column * cells_, row * cells_);
            const float reach_m = std::max({-block.low_m.x, block.high_m.x, -block.low_m.z, block.high_m.z});
            block.is_drawn = reach_m >= hole_half_side_m;
            blocks_.push_back(block);
            add_errors(height_m, column * cells_, row * cells_);
        }
    }
}

Blocks::Block Blocks::bounded(const mesh::Field& height_m, int column, int row) const {
    float lowest = height_m.at(column, row);
    float highest = lowest;
    for (int r = row; r <= row + cells_; ++r) {
        const float* heights = &height_m.at(column, r);
        for (int c = 0; c <= cells_; ++c) {
            lowest = std::min(lowest, heights[c]);
            highest = std::max(highest, heights[c]);
        }
    }
    const float middle = static_cast<float>(columns_ - 1) / 2;
    const auto metres = [&](int sample) { return (static_cast<float>(sample) - middle) * cell_m_; };
    return {{metres(column), lowest, metres(row)}, {metres(column + cells_), highest, metres(row + cells_)}, true};
}

// Each level drops the vertices that are odd at its step; what the surface moves by there is what it loses.
void Blocks::add_errors(const mesh::Field& height_m, int column, int row) {
    float sum_m = 0;
    errors_m_.push_back(0);
    for (int level = 1; level <= coarsest_; ++level) {
        const int half = 1 << (level - 1);
        const int step = 2 * half;
        float worst_m = 0;
        const auto lost = [&](int c, int r, int dc, int dr) {
            const float mean = 0.5F * (height_m.at(c - dc, r - dr) + height_m.at(c + dc, r + dr));
            worst_m = std::max(worst_m, std::abs(height_m.at(c, r) - mean));
        };
        for (int r = row; r <= row + cells_; r += step) {
            for (int c = column; c <= column + cells_; c += step) {
                if (c < column + cells_) lost(c + half, r, half, 0);
                if (r < row + cells_) lost(c, r + half, 0, half);
                // The diagonal that make_offsets draws runs from south-west to north-east.
                if (c < column + cells_ && r < row + cells_) lost(c + half, r + half, half, -half);
            }
        }
        sum_m += worst_m;
        errors_m_.push_back(sum_m);
    }
}

float Blocks::distance_to(const Block& block, glm::vec3 eye_m) const {
    return glm::length(eye_m - glm::clamp(eye_m, block.low_m, block.high_m));
}

int Blocks::level_of(int block, const Wish& wish) const {
    const float distance_m = distance_to(blocks_[static_cast<std::size_t>(block)], wish.eye_m);
    const float allowed_m = wish.error_px * distance_m / wish.pixels_per_radian;
    int level = coarsest_;
    while (level > 0 && error_m(block, level) > allowed_m) --level;
    return level;
}

float Blocks::affordable_error_px(const std::vector<int>& seen, Wish wish) const {
    const auto triangles = [&] {
        std::size_t sum = 0;
        for (const int block : seen) {
            const auto side = static_cast<std::size_t>(cells_ >> level_of(block, wish));
            sum += 2 * side * side;
        }
        return sum;
    };
    // In steps, so that a camera that moves a little seldom changes it.
    while (wish.error_px < 64 && triangles() > wish.triangle_budget) wish.error_px *= 1.25F;
    return wish.error_px;
}

std::size_t Blocks::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    std::vector<std::pair<float, int>> seen;
    std::vector<int> seen_blocks;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (!blocks_[i].is_drawn || !frustum.may_see_box(blocks_[i].low_m, blocks_[i].high_m)) continue;
        seen.emplace_back(distance_to(blocks_[i], wish.eye_m), static_cast<int>(i));
        seen_blocks.push_back(static_cast<int>(i));
    }
    Wish affordable = wish;
    affordable.error_px = affordable_error_px(seen_blocks, wish);
    std::vector<int> levels(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) levels[i] = level_of(static_cast<int>(i), affordable);
    std::ranges::sort(seen);
    const std::size_t before = indices.size();
    for (const auto& [distance_m, i] : seen) {
        const int row = i / side_;
        const int column = i % side_;
        const int own = levels[static_cast<std::size_t>(i)];
        const auto edge = [&](int c, int r) {
            const bool is_rim = c < 0 || r < 0 || c >= side_ || r >= side_;
            return is_rim ? own : std::max(own, levels[static_cast<std::size_t>(r * side_ + c)]);
        };
        const auto& offsets = offsets_of(
            {own, edge(column, row - 1), edge(column + 1, row), edge(column, row + 1), edge(column - 1, row)});
        const auto first = static_cast<std::uint32_t>(row * cells_ * columns_ + column * cells_);
        for (const std::uint32_t offset : offsets) indices.push_back(first + offset);
    }
    return (indices.size() - before) / 3;
}

const std::vector<std::uint32_t>& Blocks::offsets_of(const Pattern& pattern) const {
    const auto known = patterns_.find(pattern);
    return known != patterns_.end() ? known->second : patterns_.emplace(pattern, make_offsets(pattern)).first->second;
}

std::vector<std::uint32_t> Blocks::make_offsets(const Pattern& pattern) const {
    const auto [level, north, east, south, west] = pattern;
    const int step = 1 << level;
    const auto snapped = [](int at, int coarse) { return at >> coarse << coarse; };
    const auto vertex = [&, n = north, e = east, s = south, w = west](int column, int row) {
        if (row == 0) column = snapped(column, n);
        if (row == cells_) column = snapped(column, s);
        if (column == 0) row = snapped(row, w);
        if (column == cells_) row = snapped(row, e);
        return static_cast<std::uint32_t>(row * columns_ + column);
    };
    std::vector<std::uint32_t> offsets;
    const auto triangle = [&offsets](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) offsets.insert(offsets.end(), {a, b, c});
    };
    for (int row = 0; row < cells_; row += step) {
        for (int column = 0; column < cells_; column += step) {
            const std::uint32_t north_west = vertex(column, row);
            const std::uint32_t north_east = vertex(column + step, row);
            const std::uint32_t south_west = vertex(column, row + step);
            const std::uint32_t south_east = vertex(column + step, row + step);
            triangle(north_west, south_west, north_east);
            triangle(north_east, south_west, south_east);
        }
    }
    return offsets;
}

}  // namespace quadrat::render::passes
