// SPDX-License-Identifier: Apache-2.0
// Blocks by the logarithm of their depth, after Vlietinck's vertex-program terrain as described in "Genetic selection
// of parametric scenes" (2003), section 6.1; borders are stitched by index instead of by a transition tiling.
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
    const float middle = static_cast<float>(columns_ - 1) / 2;
    const auto metres = [&](int sample) { return (static_cast<float>(sample) - middle) * cell_m_; };
    for (int row = 0; row < side_; ++row) {
        for (int column = 0; column < side_; ++column) {
            const int c0 = column * cells_;
            const int r0 = row * cells_;
            float lowest = height_m.at(c0, r0);
            float highest = lowest;
            for (int r = r0; r <= r0 + cells_; ++r) {
                for (int c = c0; c <= c0 + cells_; ++c) {
                    lowest = std::min(lowest, height_m.at(c, r));
                    highest = std::max(highest, height_m.at(c, r));
                }
            }
            Block block{{metres(c0), lowest, metres(r0)}, {metres(c0 + cells_), highest, metres(r0 + cells_)}, true};
            const float reach =
                std::max(std::max(-block.low_m.x, block.high_m.x), std::max(-block.low_m.z, block.high_m.z));
            block.is_drawn = reach >= hole_half_side_m;
            blocks_.push_back(block);
        }
    }
}

float Blocks::distance_to(const Block& block, glm::vec3 eye_m) const {
    return glm::length(eye_m - glm::clamp(eye_m, block.low_m, block.high_m));
}

int Blocks::level_at(float distance_m, const Wish& wish) const {
    const float cell_px = cell_m_ * wish.pixels_per_radian / std::max(distance_m, 1.0F);
    return std::clamp(static_cast<int>(std::floor(std::log2(wish.cell_px / cell_px))), 0, coarsest_);
}

std::size_t Blocks::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    std::vector<int> levels(blocks_.size());
    std::vector<std::pair<float, int>> seen;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const float distance_m = distance_to(blocks_[i], wish.eye_m);
        levels[i] = level_at(distance_m, wish);
        if (blocks_[i].is_drawn && frustum.may_see_box(blocks_[i].low_m, blocks_[i].high_m))
            seen.emplace_back(distance_m, static_cast<int>(i));
    }
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
