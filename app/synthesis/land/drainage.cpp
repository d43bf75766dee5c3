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

// A priority queue of cells for levels that never come in below the one last taken: buckets are lists threaded through
// the cells, and only the lowest is kept as a heap.
class RisingQueue {
  public:
    RisingQueue(const std::vector<float>& levels, float low, float high)
        : levels_(levels), low_(low), next_(levels.size(), kNone), first_(levels.size() / 8 + 2, kNone) {
        per_unit_ = static_cast<float>(first_.size() - 1) / std::max(high - low, 1.0e-6F);
    }

    void push(std::int32_t cell) {
        const std::size_t b = bucket_of(levels_[cell]);
        if (b <= current_) {
            heap_.push_back(cell);
            std::push_heap(heap_.begin(), heap_.end(), Later{levels_});
        } else {
            next_[cell] = first_[b];
            first_[b] = cell;
        }
        ++size_;
    }
    bool is_empty() const { return size_ == 0; }
    std::int32_t pop() {
        while (heap_.empty()) {
            ++current_;
            for (std::int32_t cell = first_[current_]; cell != kNone; cell = next_[cell]) heap_.push_back(cell);
            std::make_heap(heap_.begin(), heap_.end(), Later{levels_});
        }
        std::pop_heap(heap_.begin(), heap_.end(), Later{levels_});
        const std::int32_t cell = heap_.back();
        heap_.pop_back();
        --size_;
        return cell;
    }

  private:
    static constexpr std::int32_t kNone = -1;

    struct Later {
        const std::vector<float>& levels;
        bool operator()(std::int32_t a, std::int32_t b) const {
            return levels[a] != levels[b] ? levels[a] > levels[b] : a > b;
        }
    };

    std::size_t bucket_of(float level) const {
        return std::min(static_cast<std::size_t>(std::max((level - low_) * per_unit_, 0.0F)), first_.size() - 1);
    }

    const std::vector<float>& levels_;
    float low_;
    float per_unit_ = 0;
    std::vector<std::int32_t> next_;
    std::vector<std::int32_t> first_;
    std::vector<std::int32_t> heap_;
    std::size_t current_ = 0;
    std::size_t size_ = 0;
};

constexpr std::array<std::array<int, 2>, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

// Fills spill levels, the flood's own ways and its order.
void flood(const mesh::Field& height_m, float sea_m, Drainage& d) {
    const int columns = height_m.columns;
    const int rows = height_m.rows;
    const auto [low, high] = std::minmax_element(height_m.samples.begin(), height_m.samples.end());
    RisingQueue queue(d.spill_m.samples, *low, *high);
    std::array<std::int32_t, 8> offsets{};
    for (std::size_t k = 0; k < 8; ++k) offsets[k] = kNeighbours[k][1] * columns + kNeighbours[k][0];

    enum State : std::uint8_t { Dry = 0, Reached = 1, Border = 2 };
    std::vector<std::uint8_t> state(height_m.samples.size(), Dry);
    const auto is_outlet = [&](std::int32_t cell) {
        return (state[cell] & Border) != 0 || height_m.samples[cell] <= sea_m;
    };
    for (int x = 0; x < columns; ++x) state[x] = state[height_m.index(x, rows - 1)] = Border;
    for (int y = 0; y < rows; ++y) state[height_m.index(0, y)] = state[height_m.index(columns - 1, y)] = Border;
    const auto reach = [&](std::int32_t cell, std::int32_t from, float level) {
        state[cell] |= Reached;
        d.receiver[cell] = from;
        d.spill_m.samples[cell] = level;
    };
    const auto count = static_cast<std::int32_t>(height_m.samples.size());
    for (std::int32_t cell = 0; cell < count; ++cell) {
        if (!is_outlet(cell)) continue;
        reach(cell, cell, height_m.samples[cell]);
        // The open sea has nothing to flood; it only comes first.
        bool is_open_sea = (state[cell] & Border) == 0;
        for (std::size_t k = 0; is_open_sea && k < 8; ++k) is_open_sea = is_outlet(cell + offsets[k]);
        if (is_open_sea)
            d.order.push_back(cell);
        else
            queue.push(cell);
    }
    // Cells that stand no higher than the water beside them need no queue.
    std::vector<std::int32_t> level_ones;
    const auto spread_to = [&](std::int32_t cell, std::int32_t next, float level) {
        if ((state[next] & Reached) != 0) return;
        const float h = height_m.samples[next];
        reach(next, cell, std::max(h, level));
        if (h <= level)
            level_ones.push_back(next);
        else
            queue.push(next);
    };
    const auto spread = [&](std::int32_t cell) {
        d.order.push_back(cell);
        const float level = d.spill_m.samples[cell];
        if ((state[cell] & Border) == 0) {
            for (const std::int32_t offset : offsets) spread_to(cell, cell + offset, level);
            return;
        }
        const int x = cell % columns;
        const int y = cell / columns;
        for (std::size_t k = 0; k < 8; ++k)
            if (height_m.is_inside(x + kNeighbours[k][0], y + kNeighbours[k][1]))
                spread_to(cell, cell + offsets[k], level);
    };
    while (!queue.is_empty()) {
        spread(queue.pop());
        for (std::size_t i = 0; i < level_ones.size(); ++i) spread(level_ones[i]);
        level_ones.clear();
    }
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
    d.order.reserve(height_m.samples.size());
    if (height_m.samples.empty()) return d;
    flood(height_m, sea_m, d);
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
