// SPDX-License-Identifier: Apache-2.0
// Blocks in powers of two, after Vlietinck's vertex-program terrain as described in "Genetic selection of parametric
// scenes" (2003), section 6.1. Ours differ: the level follows the block's own roughness as well as its depth, and
// borders are stitched by index instead of by a transition tiling.
#include "render/choose/blocks.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace quadrat::render::choose {
namespace {

constexpr float kMostError_px = 64;
constexpr float kLeastGrowth = 2;  // of a level's error over the finer one's: its vertices move after those of that one

int largest_block(int cells, int wanted) {
    while (wanted > 1 && cells % wanted != 0) wanted /= 2;
    return std::max(wanted, 1);
}

}  // namespace

Blocks::Blocks(const mesh::Field& height_m, float cell_m, int block_cells, float hole_half_side_m)
    : columns_(height_m.columns),
      cell_m_(cell_m),
      cells_(largest_block(columns_ - 1, block_cells)),
      side_((columns_ - 1) / cells_),
      coarsest_(std::bit_width(static_cast<unsigned>(cells_)) - 1),
      hole_half_side_m_(hole_half_side_m) {
    assert(height_m.columns >= 2 && height_m.rows == height_m.columns);
    blocks_.reserve(static_cast<std::size_t>(side_ * side_));
    errors_m_.reserve(entry(side_ * side_, 0));
    for (int row = 0; row < side_; ++row) measure_row(height_m, row);
}

void Blocks::measure_row(const mesh::Field& height_m, int row) {
    for (int column = 0; column < side_; ++column) {
        Block block = bounded(height_m, column * cells_, row * cells_);
        const float reach_m = std::max({-block.low_m.x, block.high_m.x, -block.low_m.z, block.high_m.z});
        block.is_drawn = reach_m >= hole_half_side_m_;
        blocks_.push_back(block);
        float error_m = 0;
        for (int level = 0; level <= coarsest_; ++level) {
            if (level > 0)
                error_m =
                    std::max(error_m * kLeastGrowth, farthest_off_m(height_m, column * cells_, row * cells_, level));
            errors_m_.push_back(error_m);
        }
    }
    bound_squares(row);
}

Blocks::Leaving Blocks::leaving(const mesh::Field& height_m, int column, int row) const {
    // The finest level that leaves it out is the one after the highest power of two in both its numbers.
    const int level = std::countr_zero(static_cast<unsigned>(column | row | cells_));
    const float own_m = height_m.at(column, row);
    if (level >= coarsest_) return {0, own_m};
    const int step = 1 << level;
    const bool is_between_columns = (column & step) != 0;
    const bool is_between_rows = (row & step) != 0;
    // On an edge of the coarser level, or on the diagonal of one of its squares, from south-west to north-east.
    const int c = is_between_columns ? step : 0;
    const int r = is_between_rows ? step : 0;
    const float coarser_m = 0.5F * (height_m.at(column - c, row + r) + height_m.at(column + c, row - r));
    // On a border it lies as near to the truth as the better of two blocks, and has moved before either's level
    // changes.
    float error_m = std::numeric_limits<float>::max();
    for (const int block_row : {(row - 1) / cells_, row / cells_})
        for (const int block_column : {(column - 1) / cells_, column / cells_})
            if (block_row < side_ && block_column < side_)
                error_m = std::min(error_m, errors_m_[entry(block_row * side_ + block_column, level + 1)]);
    return {error_m, coarser_m};
}

float Blocks::eased(float distance_m, float error_m, const Wish& wish) {
    if (error_m <= 0) return 0;
    const float share = distance_m * wish.error_px / (wish.pixels_per_radian * error_m);
    return std::clamp((share - kEaseFrom) / (1 - kEaseFrom), 0.0F, 1.0F);
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

// Over the two triangles of every cell of the level, whose diagonal runs from south-west to north-east as in
// make_offsets(): along a row of samples each is a straight line.
float Blocks::farthest_off_m(const mesh::Field& height_m, int column, int row, int level) const {
    const int step = 1 << level;
    const float share = 1.0F / static_cast<float>(step);
    float worst_m = 0;
    for (int r = 0; r <= cells_; ++r) {
        const int above = std::min(r & ~(step - 1), cells_ - step);
        const float down = static_cast<float>(r - above) * share;
        const float* samples = &height_m.at(column, row + r);
        const float* upper = &height_m.at(column, row + above);
        const float* lower = &height_m.at(column, row + above + step);
        for (int left = 0; left < cells_; left += step) {
            const float west = upper[left] + down * (lower[left] - upper[left]);
            const float rise_east = (upper[left + step] - upper[left]) * share;
            const float east = upper[left + step] + down * (lower[left + step] - upper[left + step]);
            const float fall_west = (lower[left] - lower[left + step]) * share;
            const int turn = step - (r - above);  // where the row crosses the diagonal
            for (int c = 0; c <= turn; ++c)
                worst_m = std::max(worst_m, std::abs(west + static_cast<float>(c) * rise_east - samples[left + c]));
            for (int c = turn + 1; c <= step; ++c)
                worst_m =
                    std::max(worst_m, std::abs(east + static_cast<float>(step - c) * fall_west - samples[left + c]));
        }
    }
    return worst_m;
}

float Blocks::distance_to(const Block& block, glm::vec3 eye_m) const {
    return glm::length(eye_m - glm::clamp(eye_m, block.low_m, block.high_m));
}

int Blocks::level_of(int block, const Wish& wish) const {
    return level_at(block, distance_to(blocks_[static_cast<std::size_t>(block)], wish.eye_m), wish);
}

int Blocks::level_at(int block, float distance_m, const Wish& wish) const {
    const float allowed_m = wish.error_px * distance_m / wish.pixels_per_radian;
    int level = coarsest_;
    while (level > 0 && error_m(block, level) > allowed_m) --level;
    return level;
}

float Blocks::affordable_error_px(const std::vector<Near>& seen, Wish wish) const {
    const auto triangles = [&] {
        std::size_t sum = 0;
        for (const Near& near : seen) {
            const auto side = static_cast<std::size_t>(cells_ >> level_at(near.block, near.distance_m, wish));
            sum += 2 * side * side;
        }
        return sum;
    };
    if (triangles() <= wish.triangle_budget) return wish.error_px;
    // So finely that a camera that moves a little changes it a little.
    float too_fine = wish.error_px;
    wish.error_px = kMostError_px;
    if (triangles() > wish.triangle_budget) return kMostError_px;
    float fits = kMostError_px;
    for (int i = 0; i < 12; ++i) {
        wish.error_px = std::sqrt(too_fine * fits);
        (triangles() <= wish.triangle_budget ? fits : too_fine) = wish.error_px;
    }
    wish.error_px = fits;
    return wish.error_px;
}

// Once the last row of blocks in a row of squares is there.
void Blocks::bound_squares(int row) {
    if (row % kSquare != kSquare - 1 && row != side_ - 1) return;
    const int first_row = row / kSquare * kSquare;
    for (int first = 0; first < side_; first += kSquare) {
        Block square = blocks_[static_cast<std::size_t>(first_row * side_ + first)];
        for (int r = first_row; r <= row; ++r) {
            for (int c = first; c < std::min(first + kSquare, side_); ++c) {
                const Block& block = blocks_[static_cast<std::size_t>(r * side_ + c)];
                square.low_m = glm::min(square.low_m, block.low_m);
                square.high_m = glm::max(square.high_m, block.high_m);
            }
        }
        squares_.push_back(square);
    }
}

std::vector<Blocks::Near> Blocks::seen_by(const Frustum& frustum, glm::vec3 eye_m,
                                          std::span<const std::uint8_t> hidden) const {
    std::vector<Near> seen;
    const int across = (side_ + kSquare - 1) / kSquare;
    for (std::size_t s = 0; s < squares_.size(); ++s) {
        const Block& square = squares_[s];
        if (!frustum.may_see_box(square.low_m, square.high_m)) continue;
        const bool is_whole = frustum.sees_whole_box(square.low_m, square.high_m);
        const int first_row = static_cast<int>(s) / across * kSquare;
        const int first_column = static_cast<int>(s) % across * kSquare;
        for (int row = first_row; row < std::min(first_row + kSquare, side_); ++row) {
            for (int column = first_column; column < std::min(first_column + kSquare, side_); ++column) {
                const int i = row * side_ + column;
                const auto at = static_cast<std::size_t>(i);
                const Block& block = blocks_[at];
                if (!block.is_drawn || (!hidden.empty() && hidden[at] != 0) ||
                    (!is_whole && !frustum.may_see_box(block.low_m, block.high_m)))
                    continue;
                seen.push_back({distance_to(block, eye_m), i});
            }
        }
    }
    return seen;
}

std::vector<std::uint8_t> Blocks::hidden(const Frustum& frustum, glm::vec3 eye_m, Horizon& horizon) const {
    std::vector<Near> seen = seen_by(frustum, eye_m, {});
    const auto box = [&](const Near& near) -> const Block& { return blocks_[static_cast<std::size_t>(near.block)]; };
    // A line of sight meets them in the order of their distance on the map.
    for (Near& near : seen) near.distance_m = Horizon::nearest_m({eye_m.x, eye_m.z}, box(near).low_m, box(near).high_m);
    std::ranges::sort(seen, {}, &Near::distance_m);
    std::vector<std::uint8_t> hidden(blocks_.size(), 0);
    // However coarse a block is drawn, it lies between its lowest and its highest sample.
    for (const Near& near : seen) {
        if (horizon.hides_box(box(near).low_m, box(near).high_m))
            hidden[static_cast<std::size_t>(near.block)] = 1;
        else
            horizon.cover(box(near).low_m, box(near).high_m);
    }
    return hidden;
}

Blocks::Selected Blocks::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    std::vector<Near> seen = seen_by(frustum, wish.eye_m, wish.hidden);
    Wish affordable = wish;
    affordable.error_px = affordable_error_px(seen, wish);
    // Only of those that are seen and, as their patterns ask for them, of their neighbours.
    constexpr int kUnknown = -1;
    std::vector<int> levels(blocks_.size(), kUnknown);
    for (const Near& near : seen)
        levels[static_cast<std::size_t>(near.block)] = level_at(near.block, near.distance_m, affordable);
    const auto known_level = [&](int block) {
        int& level = levels[static_cast<std::size_t>(block)];
        if (level == kUnknown) level = level_of(block, affordable);
        return level;
    };
    // No distance is negative: as a number its bits are in the same order.
    std::ranges::sort(seen, {}, [](const Near& near) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(near.distance_m)} << 32U | static_cast<unsigned>(near.block);
    });
    const std::size_t before = indices.size();
    Selected selected;
    selected.error_px = affordable.error_px;
    for (const auto& [distance_m, i] : seen) {
        const Block& block = blocks_[static_cast<std::size_t>(i)];
        if (!wish.reach.may_hold_ground(block.low_m, block.high_m)) continue;
        const int row = i / side_;
        const int column = i % side_;
        const int own = levels[static_cast<std::size_t>(i)];
        const auto edge = [&](int c, int r) {
            const bool is_rim = c < 0 || r < 0 || c >= side_ || r >= side_;
            return is_rim ? own : std::max(own, known_level(r * side_ + c));
        };
        const auto& offsets = offsets_of(
            {own, edge(column, row - 1), edge(column + 1, row), edge(column, row + 1), edge(column - 1, row)});
        const auto first = static_cast<std::uint32_t>(row * cells_ * columns_ + column * cells_);
        const std::size_t end = indices.size();
        indices.insert(indices.end(), offsets.begin(), offsets.end());
        std::uint32_t* at = indices.data() + end;
        for (std::size_t k = 0; k < offsets.size(); ++k) at[k] += first;
        if (distance_m < wish.near_m) selected.near_indices = indices.size() - before;
    }
    selected.triangles = (indices.size() - before) / 3;
    return selected;
}

const std::vector<std::uint32_t>& Blocks::offsets_of(const Pattern& pattern) const {
    std::size_t place = 0;
    for (const int level : pattern)
        place = place * static_cast<std::size_t>(coarsest_ + 1) + static_cast<std::size_t>(level);
    if (patterns_.empty()) patterns_.resize(static_cast<std::size_t>(std::pow(coarsest_ + 1, pattern.size())));
    if (patterns_[place].empty()) patterns_[place] = make_offsets(pattern);
    return patterns_[place];
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

float ease_of(const Blocks::Wish& wish, float error_px) {
    // Never later than the blocks change: a rounding error more.
    constexpr float kMargin = 1.002F;
    return kMargin * error_px / (wish.pixels_per_radian * kErrorUnit_m * (1 - Blocks::kEaseFrom));
}

}  // namespace quadrat::render::choose
