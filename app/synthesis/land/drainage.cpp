// SPDX-License-Identifier: Apache-2.0
// G. Cordonnier, B. Bovy & J. Braun, "A versatile, linear complexity algorithm for flow routing in topographies with
// depressions", 2019: every cell drains to a neighbour, the hollows so found are joined over their lowest passes by a
// minimum spanning tree (Boruvka), and the way from each pass down to its hollow's floor is turned about. The levels
// are those of R. Barnes, C. Lehman & D. Mulla, "Priority-flood", 2014, to the bit, without its queue. Changed: chance
// disturbs the choice among the ways down.
#include "synthesis/land/drainage.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

#include "synthesis/land/steepest_row.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr std::array<std::array<int, 2>, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
constexpr std::int32_t kUnknown = -1;
constexpr std::int32_t kOutside = 0;  // the basin of all that drains to an outlet by itself

template <typename Rows>
void for_rows(int first, int last, const Rows& rows) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(first, last, 16),
                              [&](const auto& range) { rows(range.begin(), range.end()); });
}

// steepest_of_row for the processor at hand.
auto steepest_row_here() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") != 0) return &steepest_of_row_avx2;
#endif
    return &steepest_of_row;
}

// Each cell's receiver on the bare ground; outlets and pits are their own.
void descend(Drainage& d, const mesh::Field& h, float sea_m, std::uint32_t wander) {
    const int columns = h.columns;
    const std::uint32_t turn = wander * 0x85EBCA6BU;
    static const auto steepest = steepest_row_here();
    for_rows(0, h.rows, [&](int first, int last) {
        const auto width = static_cast<std::size_t>(columns);
        std::vector<std::int32_t> offset(width);
        std::vector<std::uint32_t> chance(width);
        std::vector<float> best(width);
        for (int y = first; y < last; ++y) {
            const std::int32_t cell = y * columns;
            std::fill(offset.begin(), offset.end(), 0);
            if (y > 0 && y < h.rows - 1)
                steepest(&h.samples[cell], columns, static_cast<std::uint32_t>(cell), turn, offset.data(),
                         chance.data(), best.data());
            for (int x = 0; x < columns; ++x)
                d.receiver[cell + x] = cell + x + (h.samples[cell + x] > sea_m ? offset[x] : 0);
        }
    });
}

// Which hollow every cell drains to: numbers from 1, a floor each; kOutside for outlets.
struct Basins {
    std::vector<std::int32_t> of;     // a cell
    std::vector<std::int32_t> floor;  // a basin: its pit; nothing sensible for kOutside
};

Basins find_basins(const Drainage& d, const mesh::Field& h, float sea_m) {
    Basins basins{std::vector<std::int32_t>(h.samples.size(), kUnknown), {kUnknown}};
    const auto own_basin = [&](std::int32_t cell) {
        const int x = cell % h.columns;
        const int y = cell / h.columns;
        const bool is_border = x == 0 || y == 0 || x == h.columns - 1 || y == h.rows - 1;
        if (is_border || h.samples[cell] <= sea_m) return kOutside;
        basins.floor.push_back(cell);
        return static_cast<std::int32_t>(basins.floor.size() - 1);
    };
    const auto count = static_cast<std::int32_t>(h.samples.size());
    for (std::int32_t start = 0; start < count; ++start) {
        if (basins.of[start] != kUnknown) continue;
        std::int32_t end = start;
        while (basins.of[end] == kUnknown && d.receiver[end] != end) end = d.receiver[end];
        if (basins.of[end] == kUnknown) basins.of[end] = own_basin(end);
        const std::int32_t basin = basins.of[end];
        for (std::int32_t cell = start; basins.of[cell] == kUnknown; cell = d.receiver[cell]) basins.of[cell] = basin;
    }
    return basins;
}

// A way over from one basin to another between two neighbouring cells, as high as the higher of them.
struct Pass {
    float height_m;
    std::int32_t basins[2];  // as they were joined so far
    std::int32_t cells[2];

    bool is_lower(const Pass& other) const {
        return std::tie(height_m, cells[0], cells[1]) < std::tie(other.height_m, other.cells[0], other.cells[1]);
    }
};

// The lowest passes found lately, one a slot: most divides run on for many cells between the same two basins.
class LatePasses {
  public:
    explicit LatePasses(std::vector<Pass>& found) : found_(found), late_(kSlots, Pass{0, {0, 0}, {0, 0}}) {}

    void add(const Pass& pass) {
        Pass& late = late_[(static_cast<std::uint32_t>(pass.basins[0]) * 0x9E3779B9U ^
                            static_cast<std::uint32_t>(pass.basins[1]) * 0x85EBCA6BU) >>
                           kShift];
        if (late.basins[0] == pass.basins[0] && late.basins[1] == pass.basins[1]) {
            if (pass.height_m < late.height_m) late = pass;
            return;
        }
        keep(late);
        late = pass;
    }
    void keep_all() {
        for (const Pass& late : late_) keep(late);
    }

  private:
    static constexpr std::size_t kSlots = 2048;
    static constexpr int kShift = 21;  // to as many bits
    void keep(const Pass& late) {
        if (late.basins[0] != late.basins[1]) found_.push_back(late);
    }

    std::vector<Pass>& found_;
    std::vector<Pass> late_;
};

// Those between a band of rows and the row after each.
std::vector<Pass> passes_of(const Basins& basins, const mesh::Field& h, int first, int last) {
    const int columns = h.columns;
    std::vector<Pass> passes;
    LatePasses late(passes);
    std::vector<std::int32_t> differs(static_cast<std::size_t>(columns), 1);
    for (int y = first; y < last; ++y) {
        const std::int32_t* on = &basins.of[h.index(0, y)];
        const std::int32_t* below = y + 1 < h.rows ? on + columns : on;
        for (int x = 1; x + 1 < columns; ++x)
            differs[x] = (on[x] ^ on[x + 1]) | (on[x] ^ below[x]) | (on[x] ^ below[x + 1]) | (on[x] ^ below[x - 1]);
        for (int x = 0; x < columns; ++x) {
            if (differs[x] == 0) continue;
            const auto cell = static_cast<std::int32_t>(h.index(x, y));
            for (const std::size_t k : {0U, 2U, 4U, 5U}) {
                const int nx = x + kNeighbours[k][0];
                if (nx < 0 || nx >= columns || y + kNeighbours[k][1] >= h.rows) continue;
                const std::int32_t next = cell + kNeighbours[k][1] * columns + kNeighbours[k][0];
                const std::int32_t a = basins.of[cell];
                const std::int32_t b = basins.of[next];
                if (a == b) continue;
                late.add(a < b ? Pass{std::max(h.samples[cell], h.samples[next]), {a, b}, {cell, next}}
                               : Pass{std::max(h.samples[cell], h.samples[next]), {b, a}, {next, cell}});
            }
        }
    }
    late.keep_all();
    return passes;
}

std::vector<Pass> find_passes(const Basins& basins, const mesh::Field& h) {
    constexpr int kBand = 128;  // of rows: what is found does not hang on the number of threads
    std::vector<std::vector<Pass>> by_band(static_cast<std::size_t>((h.rows + kBand - 1) / kBand));
    oneapi::tbb::parallel_for(std::size_t{0}, by_band.size(), [&](std::size_t band) {
        const int first = static_cast<int>(band) * kBand;
        by_band[band] = passes_of(basins, h, first, std::min(first + kBand, h.rows));
    });
    std::vector<Pass> passes;
    for (const auto& some : by_band) passes.insert(passes.end(), some.begin(), some.end());
    return passes;
}

// The passes of the minimum spanning tree over all basins: each round every group of basins takes its lowest pass.
std::vector<Pass> lowest_passes(std::vector<Pass> passes, std::size_t basin_count) {
    std::vector<Pass> tree;
    std::vector<std::int32_t> group(basin_count);
    for (std::size_t i = 0; i < basin_count; ++i) group[i] = static_cast<std::int32_t>(i);
    const auto root_of = [&group](std::int32_t basin) {
        while (group[basin] != basin) basin = group[basin] = group[group[basin]];
        return basin;
    };
    std::vector<std::int32_t> lowest(basin_count);
    while (!passes.empty()) {
        std::fill(lowest.begin(), lowest.end(), kUnknown);
        std::size_t kept = 0;
        for (Pass pass : passes) {
            for (std::int32_t& basin : pass.basins) basin = root_of(basin);
            if (pass.basins[0] == pass.basins[1]) continue;
            for (const std::int32_t basin : pass.basins)
                if (lowest[basin] == kUnknown || pass.is_lower(passes[lowest[basin]]))
                    lowest[basin] = static_cast<std::int32_t>(kept);
            passes[kept++] = pass;
        }
        passes.resize(kept);
        for (const std::int32_t way : lowest) {
            if (way == kUnknown) continue;
            const std::int32_t a = root_of(passes[way].basins[0]);
            const std::int32_t b = root_of(passes[way].basins[1]);
            if (a == b) continue;
            group[std::max(a, b)] = std::min(a, b);
            tree.push_back(passes[way]);
        }
    }
    return tree;
}

// From the pass down to the floor, every cell is made to drain to the one before it.
void turn_about(Drainage& d, std::int32_t at_pass, std::int32_t over_it, std::int32_t floor) {
    std::int32_t cell = at_pass;
    std::int32_t before = over_it;
    while (true) {
        const std::int32_t next = d.receiver[cell];
        d.receiver[cell] = before;
        if (cell == floor) return;
        before = cell;
        cell = next;
    }
}

// Joins every basin to the outside; returns the level each fills to.
std::vector<float> join(Drainage& d, const Basins& basins, const std::vector<Pass>& tree) {
    const std::size_t count = basins.floor.size();
    std::vector<std::int32_t> first(count + 1, 0);
    for (const Pass& pass : tree)
        for (const std::int32_t cell : pass.cells) ++first[basins.of[cell] + 1];
    for (std::size_t i = 0; i < count; ++i) first[i + 1] += first[i];
    std::vector<std::int32_t> ways(2 * tree.size());
    std::vector<std::int32_t> filled(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < tree.size(); ++i)
        for (const std::int32_t cell : tree[i].cells) ways[filled[basins.of[cell]]++] = static_cast<std::int32_t>(i);
    std::vector<float> level_m(count, std::numeric_limits<float>::infinity());
    level_m[kOutside] = -std::numeric_limits<float>::infinity();
    std::vector<std::int32_t> reached{kOutside};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const std::int32_t basin = reached[i];
        for (std::int32_t k = first[basin]; k < first[basin + 1]; ++k) {
            const Pass& pass = tree[ways[k]];
            const std::size_t near = basins.of[pass.cells[0]] == basin ? 0 : 1;
            const std::int32_t next = basins.of[pass.cells[1 - near]];
            if (level_m[next] < std::numeric_limits<float>::infinity()) continue;
            level_m[next] = std::max(level_m[basin], pass.height_m);
            turn_about(d, pass.cells[1 - near], pass.cells[near], basins.floor[next]);
            reached.push_back(next);
        }
    }
    return level_m;
}

// Receivers first: springs are walked down until a confluence waits for its other arms; the list fills from its end,
// and the cells drained through each are counted on the way.
void put_in_order(Drainage& d) {
    const std::size_t count = d.receiver.size();
    std::vector<std::uint8_t> arms(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        if (d.receiver[i] != static_cast<std::int32_t>(i)) ++arms[d.receiver[i]];
    constexpr std::uint8_t kDone = 255;
    d.order.resize(count);
    d.drained_cells.assign(count, 1.0F);
    std::size_t at = count;
    for (std::size_t i = 0; i < count; ++i) {
        auto cell = static_cast<std::int32_t>(i);
        while (arms[cell] == 0) {
            arms[cell] = kDone;
            d.order[--at] = cell;
            const std::int32_t to = d.receiver[cell];
            if (to == cell) break;
            d.drained_cells[to] += d.drained_cells[cell];
            --arms[to];
            // What lies ahead of the scan is left to it, in its turn, so that memory is read in order.
            if (to > cell && static_cast<std::size_t>(to) > i && arms[to] == 0) break;
            cell = to;
        }
    }
}

}  // namespace

Drainage drain(const mesh::Field& height_m, float sea_m, std::uint32_t wander) {
    Drainage d;
    d.spill_m = height_m;
    d.receiver.resize(height_m.samples.size());
    if (height_m.samples.empty()) return d;
    descend(d, height_m, sea_m, wander);
    const Basins basins = find_basins(d, height_m, sea_m);
    if (basins.floor.size() > 1) {
        const auto tree = lowest_passes(find_passes(basins, height_m), basins.floor.size());
        const std::vector<float> level_m = join(d, basins, tree);
        for_rows(0, height_m.rows, [&](int first, int last) {
            for (std::size_t i = height_m.index(0, first); i < height_m.index(0, last); ++i)
                d.spill_m.samples[i] = std::max(height_m.samples[i], level_m[basins.of[i]]);
        });
    }
    put_in_order(d);
    return d;
}

std::vector<float> drained_area_m2(const Drainage& d, float cell_m) {
    std::vector<float> area_m2(d.drained_cells.size());
    for (std::size_t i = 0; i < area_m2.size(); ++i) area_m2[i] = cell_m * cell_m * d.drained_cells[i];
    return area_m2;
}

}  // namespace quadrat::synthesis::land
