// SPDX-License-Identifier: Apache-2.0
// R. Barnes, C. Lehman & D. Mulla, "Priority-flood: an optimal depression-filling and watershed-labeling algorithm",
// 2014. Changed: the queue is a row of buckets of which only the lowest is kept as a heap, and the order in which cells
// leave it is kept as the order of drainage.
#include "synthesis/land/drainage.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/seed.hpp"

namespace quadrat::synthesis::land {
namespace {

// All that the flood touches of a cell, side by side; the grid has a rim of reached cells, so that no neighbour needs a
// check.
struct FloodCell {
    float height_m = 0;
    float level_m = 0;
    std::int32_t receiver = kRim;
    std::int32_t next = kNone;  // in its bucket's list

    static constexpr std::int32_t kNone = -1;
    static constexpr std::int32_t kDry = -1;  // not reached yet
    static constexpr std::int32_t kRim = 0;
};

// A priority queue of cells for levels that never come in below the one last taken: buckets are lists threaded through
// the cells, and only the lowest is kept as a heap.
class RisingQueue {
  public:
    RisingQueue(std::vector<FloodCell>& cells, float low, float high)
        : cells_(cells), low_(low), first_(cells.size() / 16 + 2, FloodCell::kNone) {
        per_unit_ = static_cast<float>(first_.size() - 1) / std::max(high - low, 1.0e-6F);
    }

    void push(std::int32_t cell) {
        const float level_m = cells_[cell].level_m;
        const std::size_t b = bucket_of(level_m);
        if (b <= current_) {
            heap_.push_back({level_m, cell});
            std::push_heap(heap_.begin(), heap_.end());
        } else {
            cells_[cell].next = first_[b];
            first_[b] = cell;
        }
        ++size_;
    }
    bool is_empty() const { return size_ == 0; }
    std::int32_t pop() {
        while (heap_.empty()) {
            ++current_;
            for (std::int32_t cell = first_[current_]; cell != FloodCell::kNone; cell = cells_[cell].next)
                heap_.push_back({cells_[cell].level_m, cell});
            std::make_heap(heap_.begin(), heap_.end());
        }
        std::pop_heap(heap_.begin(), heap_.end());
        const std::int32_t cell = heap_.back().cell;
        heap_.pop_back();
        --size_;
        return cell;
    }

  private:
    struct Entry {
        float level_m;
        std::int32_t cell;
        friend bool operator<(const Entry& a, const Entry& b) {  // the lowest on top
            return a.level_m != b.level_m ? a.level_m > b.level_m : a.cell > b.cell;
        }
    };
    std::size_t bucket_of(float level_m) const {
        return std::min(static_cast<std::size_t>(std::max((level_m - low_) * per_unit_, 0.0F)), first_.size() - 1);
    }

    std::vector<FloodCell>& cells_;
    float low_;
    float per_unit_ = 0;
    std::vector<std::int32_t> first_;
    std::vector<Entry> heap_;
    std::size_t current_ = 0;
    std::size_t size_ = 0;
};

constexpr std::array<std::array<int, 2>, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

// The flood itself, over cells with a rim; returns them in the order it reached them for good.
std::vector<std::int32_t> flood(std::vector<FloodCell>& cells, int columns, int rows, float sea_m) {
    const int width = columns + 2;
    float low = cells[width + 1].height_m;
    float high = low;
    for (const FloodCell& cell : cells) {
        if (cell.receiver == FloodCell::kRim) continue;
        low = std::min(low, cell.height_m);
        high = std::max(high, cell.height_m);
    }
    RisingQueue queue(cells, low, high);
    std::array<std::int32_t, 8> offsets{};
    for (std::size_t k = 0; k < 8; ++k) offsets[k] = kNeighbours[k][1] * width + kNeighbours[k][0];
    std::vector<std::int32_t> order;
    order.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto is_sea = [&](int cell) { return cells[cell].height_m <= sea_m; };
    for (int y = 1; y <= rows; ++y) {
        for (int x = 1; x <= columns; ++x) {
            const int cell = y * width + x;
            const bool is_border = x == 1 || y == 1 || x == columns || y == rows;
            if (!is_border && !is_sea(cell)) continue;
            cells[cell].receiver = cell;
            cells[cell].level_m = cells[cell].height_m;
            // The open sea has nothing to flood; it only comes first.
            bool is_open_sea = !is_border;
            for (std::size_t k = 0; is_open_sea && k < 8; ++k) is_open_sea = is_sea(cell + offsets[k]);
            if (is_open_sea)
                order.push_back(cell);
            else
                queue.push(cell);
        }
    }
    // Cells that stand no higher than the water beside them need no queue.
    std::vector<std::int32_t> level_ones;
    const auto spread = [&](std::int32_t cell) {
        order.push_back(cell);
        const float level_m = cells[cell].level_m;
        for (const std::int32_t offset : offsets) {
            FloodCell& next = cells[cell + offset];
            if (next.receiver != FloodCell::kDry) continue;
            next.receiver = cell;
            next.level_m = std::max(next.height_m, level_m);
            if (next.height_m <= level_m)
                level_ones.push_back(cell + offset);
            else
                queue.push(cell + offset);
        }
    };
    while (!queue.is_empty()) {
        spread(queue.pop());
        for (std::size_t i = 0; i < level_ones.size(); ++i) spread(level_ones[i]);
        level_ones.clear();
    }
    return order;
}

std::vector<FloodCell> with_rim(const mesh::Field& height_m) {
    const int width = height_m.columns + 2;
    std::vector<FloodCell> cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height_m.rows + 2));
    for (int y = 0; y < height_m.rows; ++y)
        for (int x = 0; x < height_m.columns; ++x)
            cells[(y + 1) * width + x + 1] = {height_m.at(x, y), 0, FloodCell::kDry, FloodCell::kNone};
    return cells;
}

// Fills spill levels, the flood's own ways and its order.
void flood_into(Drainage& d, const mesh::Field& height_m, float sea_m) {
    const int columns = height_m.columns;
    const int width = columns + 2;
    std::vector<FloodCell> cells = with_rim(height_m);
    const std::vector<std::int32_t> order = flood(cells, columns, height_m.rows, sea_m);
    const auto without_rim = [width](std::int32_t cell) {
        const auto row =
            static_cast<std::int32_t>(static_cast<std::uint32_t>(cell) / static_cast<std::uint32_t>(width));
        return cell - width - 1 - 2 * (row - 1);
    };
    d.order.resize(order.size());
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, order.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) d.order[i] = without_rim(order[i]);
    });
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, height_m.rows, 16), [&](const auto& lines) {
        for (int y = lines.begin(); y != lines.end(); ++y) {
            for (int x = 0; x < columns; ++x) {
                const FloodCell& cell = cells[(y + 1) * width + x + 1];
                d.spill_m.at(x, y) = cell.level_m;
                d.receiver[height_m.index(x, y)] = without_rim(cell.receiver);
            }
        }
    });
}

// The steepest way down the flooded surface, where there is one.
void find_steepest(Drainage& d, std::uint32_t wander) {
    const int columns = d.spill_m.columns;
    const int rows = d.spill_m.rows;
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(1, rows - 1, 16), [&](const auto& lines) {
        for (int y = lines.begin(); y != lines.end(); ++y) {
            for (int x = 1; x < columns - 1; ++x) {
                const std::int32_t cell = y * columns + x;
                if (d.receiver[cell] == cell) continue;
                const float here = d.spill_m.samples[cell];
                std::uint32_t chance = (static_cast<std::uint32_t>(cell) ^ (wander * 0x85EBCA6BU)) * 0x9E3779B9U;
                chance = (chance ^ (chance >> 15U)) * 0x2C1B3C6DU;
                chance ^= chance >> 13U;
                float steepest = 0;
                for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
                    const std::int32_t next = cell + kNeighbours[k][1] * columns + kNeighbours[k][0];
                    const float fall = here - d.spill_m.samples[next];
                    if (fall <= 0) continue;
                    const float luck = 0.55F + 0.9F * static_cast<float>((chance >> (4U * k)) & 15U) / 15.0F;
                    const float slope = fall * luck * (k < 4 ? 1.0F : 0.70710678F);
                    if (slope > steepest) {
                        steepest = slope;
                        d.receiver[cell] = next;
                    }
                }
            }
        }
    });
}

}  // namespace

Drainage drain(const mesh::Field& height_m, float sea_m, std::uint32_t wander) {
    Drainage d;
    d.spill_m = mesh::Field(height_m.columns, height_m.rows);
    d.receiver.assign(height_m.samples.size(), -1);
    if (height_m.samples.empty()) return d;
    flood_into(d, height_m, sea_m);
    find_steepest(d, wander);
    return d;
}

std::vector<float> drained_area_m2(const Drainage& d, float cell_m) {
    std::vector<float> area(d.receiver.size(), cell_m * cell_m);
    for (std::size_t i = d.order.size(); i-- > 0;) {
        const std::int32_t cell = d.order[i];
        if (d.receiver[cell] != cell) area[d.receiver[cell]] += area[cell];
    }
    return area;
}

}  // namespace quadrat::synthesis::land
