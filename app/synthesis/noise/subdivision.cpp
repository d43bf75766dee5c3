// SPDX-License-Identifier: Apache-2.0
// Displacements after D. Saupe in "The Science of Fractal Images", 1988, chapter 2: deviation 2^(-H level), and at the
// half level between squares and diamonds 2^(-H/2) of it.
#include "synthesis/noise/subdivision.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace quadrat::synthesis::noise {
namespace {

// Inclusive range of lattice points of one level, both ways.
struct Region {
    int x0, x1, y0, y1;
    int columns() const { return std::max(0, x1 - x0 + 1); }
    int rows() const { return std::max(0, y1 - y0 + 1); }
};

// A row of a region, by the lattice's own column numbers.
template <typename Value>
struct Row {
    Value* first = nullptr;
    int x0 = 0;
    Value& operator[](int x) const { return first[x - x0]; }
};

struct Lattice {
    Region region{};
    std::vector<float> values;

    explicit Lattice(const Region& r)
        : region(r), values(static_cast<std::size_t>(r.columns()) * static_cast<std::size_t>(r.rows())) {}
    Row<const float> row(int y) const { return {values.data() + offset(y), region.x0}; }
    Row<float> row(int y) { return {values.data() + offset(y), region.x0}; }

  private:
    std::size_t offset(int y) const {
        return static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(region.columns());
    }
};

// The displacement of a point: unit deviation, triangular, from the hash of what the point is.
struct Displacement {
    std::uint32_t key;
    float scale;

    float operator()(int x, int y) const {
        std::uint32_t h =
            key ^ (static_cast<std::uint32_t>(x) * 0x1E35A7BDU) ^ (static_cast<std::uint32_t>(y) * 0x5851F42DU);
        h ^= h >> 16U;
        h *= 0x7FEB352DU;
        h ^= h >> 15U;
        h *= 0x846CA68BU;
        h ^= h >> 16U;
        const auto sum = static_cast<std::int32_t>((h & 0xFFFFU) + (h >> 16U)) - 65535;
        return scale * static_cast<float>(sum);
    }
};

constexpr float kUnitDeviation = 2.4494897F / 65536.0F;  // sqrt 6: of the sum of two uniforms

Displacement displacement(base::Seed seed, int level, float hurst_levels, float hurst) {
    const base::Seed at = seed.child(static_cast<std::uint64_t>(level));
    return {static_cast<std::uint32_t>(at.value ^ (at.value >> 32U)),
            kUnitDeviation * std::exp2(-hurst * hurst_levels)};
}

template <typename Row>
void for_rows(int first, int last, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(first, last + 1, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

int floor_half(int i) { return i >= 0 ? i / 2 : (i - 1) / 2; }
int ceil_half(int i) { return -floor_half(-i); }

// What of the coarser level the finer region needs: one point more on each side where diamonds look past it.
Region parents(const Region& r, int coarse_last, int past) {
    const auto clamped = [coarse_last](int i) { return std::clamp(i, 0, coarse_last); };
    return {clamped(floor_half(r.x0 - past)), clamped(ceil_half(r.x1 + past)), clamped(floor_half(r.y0 - past)),
            clamped(ceil_half(r.y1 + past))};
}

// One level of the three schemes that keep the points they have.
class MidpointStep {
  public:
    MidpointStep(Scheme scheme, const Lattice& coarse, int coarse_last, Lattice& fine, const Displacement& centre,
                 const Displacement& edge)
        : scheme_(scheme), coarse_(coarse), last_(coarse_last), fine_(fine), centre_(centre), edge_(edge) {}

    void run() const {
        const int past = scheme_ == Scheme::DiamondSquare ? 1 : 0;
        const Region& r = fine_.region;
        // Cells whose centres are needed: those in the fine region, and for diamonds those beside it.
        const Region cells{std::max(floor_half(r.x0 - past), 0), std::min(floor_half(r.x1 + past), last_ - 1),
                           std::max(floor_half(r.y0 - past), 0), std::min(floor_half(r.y1 + past), last_ - 1)};
        Lattice centres(cells);
        for_rows(cells.y0, cells.y1, [&](int y) { fill_centres(centres, y); });
        for_rows(r.y0, r.y1, [&](int y) {
            if ((y & 1) == 0)
                even_row(centres, y);
            else
                odd_row(centres, y);
        });
    }

  private:
    void fill_centres(Lattice& centres, int y) const {
        const Region& cells = centres.region;
        // Cells at the border of the region may lack corners only when no point in it asks for them.
        if (y < coarse_.region.y0 || y + 1 > coarse_.region.y1) return;
        const auto above = coarse_.row(y);
        const auto below = coarse_.row(y + 1);
        const auto out = centres.row(y);
        const int first = std::max(cells.x0, coarse_.region.x0);
        const int last = std::min(cells.x1, coarse_.region.x1 - 1);
        for (int x = first; x <= last; ++x) {
            float mean = 0;
            if (scheme_ == Scheme::DiamondSquare)
                mean = 0.25F * ((above[x] + above[x + 1]) + (below[x] + below[x + 1]));
            else if (scheme_ == Scheme::TriangleEdge || ((x + y) & 1) == 0)
                mean = 0.5F * (above[x] + below[x + 1]);
            else
                mean = 0.5F * (above[x + 1] + below[x]);
            out[x] = mean + centre_(2 * x + 1, 2 * y + 1);
        }
    }

    // Points on coarse rows: those that are, and the midpoints between them.
    void even_row(const Lattice& centres, int y) const {
        const Region& r = fine_.region;
        const int line = y / 2;
        const auto on = coarse_.row(line);
        const auto out = fine_.row(y);
        for (int x = r.x0 + (r.x0 & 1); x <= r.x1; x += 2) out[x] = on[x / 2];
        const bool has_above = scheme_ == Scheme::DiamondSquare && line > 0;
        const bool has_below = scheme_ == Scheme::DiamondSquare && line < last_;
        const auto above = has_above ? centres.row(line - 1) : Row<const float>{};
        const auto below = has_below ? centres.row(line) : Row<const float>{};
        for (int x = r.x0 | 1; x <= r.x1; x += 2) {
            const int i = x / 2;
            float mean = 0.5F * (on[i] + on[i + 1]);
            if (has_above && has_below)
                mean = 0.25F * ((on[i] + on[i + 1]) + (above[i] + below[i]));
            else if (has_above || has_below)
                mean = ((on[i] + on[i + 1]) + (has_above ? above[i] : below[i])) * (1.0F / 3.0F);
            out[x] = mean + edge_(x, y);
        }
    }

    // Points between coarse rows: centres, and the midpoints of upright sides.
    void odd_row(const Lattice& centres, int y) const {
        const Region& r = fine_.region;
        const int line = y / 2;
        const auto above = coarse_.row(line);
        const auto below = coarse_.row(line + 1);
        const auto centre = centres.row(line);
        const auto out = fine_.row(y);
        for (int x = r.x0 | 1; x <= r.x1; x += 2) out[x] = centre[x / 2];
        for (int x = r.x0 + (r.x0 & 1); x <= r.x1; x += 2) {
            const int i = x / 2;
            float mean = 0.5F * (above[i] + below[i]);
            if (scheme_ == Scheme::DiamondSquare) {
                if (i > 0 && i < last_)
                    mean = 0.25F * ((above[i] + below[i]) + (centre[i - 1] + centre[i]));
                else
                    mean = ((above[i] + below[i]) + (i > 0 ? centre[i - 1] : centre[i])) * (1.0F / 3.0F);
            }
            out[x] = mean + edge_(x, y);
        }
    }

    Scheme scheme_;
    const Lattice& coarse_;
    int last_;  // of the coarse level's points
    Lattice& fine_;
    Displacement centre_, edge_;
};

mesh::Field cut(const Lattice& lattice, const Window& w) {
    mesh::Field field(w.columns, w.rows);
    for (int row = 0; row < w.rows; ++row) {
        const float* from = &lattice.row(w.row + row)[w.column];
        std::copy(from, from + w.columns, field.samples.begin() + static_cast<std::ptrdiff_t>(field.index(0, row)));
    }
    return field;
}

int levels_for(int size) {
    int levels = 0;
    while ((1 << levels) + 1 < size) ++levels;
    return levels;
}

mesh::Field by_midpoints(const Subdivision& how, const Window& window, base::Seed seed) {
    const int levels = levels_for(how.size);
    const int past = how.scheme == Scheme::DiamondSquare ? 1 : 0;
    std::vector<Region> regions(static_cast<std::size_t>(levels) + 1);
    regions[levels] = {window.column, window.column + window.columns - 1, window.row, window.row + window.rows - 1};
    for (int level = levels; level > 0; --level) regions[level - 1] = parents(regions[level], 1 << (level - 1), past);
    Lattice lattice(regions[0]);
    const Displacement corners = displacement(seed, 1000, 0, how.hurst);
    for (int y = regions[0].y0; y <= regions[0].y1; ++y)
        for (int x = regions[0].x0; x <= regions[0].x1; ++x) lattice.row(y)[x] = corners(x, y);
    for (int level = 1; level <= levels; ++level) {
        Lattice fine(regions[level]);
        const auto at = static_cast<float>(level);
        const float half = how.scheme == Scheme::TriangleEdge ? 0.0F : 0.5F;
        MidpointStep(how.scheme, lattice, 1 << (level - 1), fine, displacement(seed, 2 * level, at - half, how.hurst),
                     displacement(seed, 2 * level + 1, at, how.hurst))
            .run();
        lattice = std::move(fine);
    }
    return cut(lattice, window);
}

// Miller's points lie at the quarters of the cells before them; a level has twice as many as the cells it came from.
mesh::Field by_quarters(const Subdivision& how, const Window& window, base::Seed seed) {
    const int levels = levels_for(how.size);
    std::vector<Region> regions(static_cast<std::size_t>(levels) + 1);
    regions[levels] = {window.column, window.column + window.columns - 1, window.row, window.row + window.rows - 1};
    for (int level = levels; level > 0; --level) {
        const Region& r = regions[level];
        regions[level - 1] = {r.x0 / 2, r.x1 / 2 + 1, r.y0 / 2, r.y1 / 2 + 1};
    }
    Lattice lattice(regions[0]);
    const Displacement corners = displacement(seed, 1000, 0, how.hurst);
    for (int y = regions[0].y0; y <= regions[0].y1; ++y)
        for (int x = regions[0].x0; x <= regions[0].x1; ++x) lattice.row(y)[x] = corners(x, y);
    for (int level = 1; level <= levels; ++level) {
        Lattice fine(regions[level]);
        const Displacement move = displacement(seed, 2 * level, static_cast<float>(level), how.hurst);
        for_rows(fine.region.y0, fine.region.y1, [&](int y) {
            const auto near = lattice.row((y + 1) / 2);
            const auto far = lattice.row((y & 1) == 0 ? y / 2 + 1 : y / 2);
            const auto out = fine.row(y);
            for (int x = fine.region.x0; x <= fine.region.x1; ++x) {
                const int i = (x + 1) / 2;
                const int k = (x & 1) == 0 ? x / 2 + 1 : x / 2;
                out[x] = (9.0F * near[i] + 3.0F * (near[k] + far[i]) + far[k]) * (1.0F / 16.0F) + move(x, y);
            }
        });
        lattice = std::move(fine);
    }
    return cut(lattice, window);
}

}  // namespace

mesh::Field subdivide(const Subdivision& how, const Window& window, base::Seed seed) {
    assert(how.size >= 2 && how.size <= 8193);
    assert(window.column >= 0 && window.row >= 0 && window.columns > 0 && window.rows > 0);
    assert(window.column + window.columns <= how.size && window.row + window.rows <= how.size);
    return how.scheme == Scheme::SquareSquare ? by_quarters(how, window, seed) : by_midpoints(how, window, seed);
}

}  // namespace quadrat::synthesis::noise
