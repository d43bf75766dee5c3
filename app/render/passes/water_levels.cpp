// SPDX-License-Identifier: Apache-2.0
#include "render/passes/water_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "mesh/field.hpp"

namespace quadrat::render::passes {
namespace {

constexpr std::uint32_t kDry = 0xFFFF'FFFF;

// A square of cells that is drawn as one.
struct Leaf {
    int x, y, cells;
};

class Surface {
  public:
    Surface(const mesh::Mesh& mesh, float cell_m, int columns)
        : mesh_(mesh), columns_(columns), corner_(columns, columns, kDry), is_wet_(columns, columns, 0) {
        const float half = 0.5F * static_cast<float>(columns - 1);
        const auto place = [&](float at_m) { return static_cast<int>(std::lround(at_m / cell_m + half)); };
        for (std::size_t i = 0; i < mesh.positions_m.size(); ++i)
            corner_.at(place(mesh.positions_m[i].x), place(mesh.positions_m[i].z)) = static_cast<std::uint32_t>(i);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return mesh.positions_m[mesh.indices[i + k]]; };
            const glm::vec3 low_m = glm::min(glm::min(at(0), at(1)), at(2));
            is_wet_.at(place(low_m.x), place(low_m.z)) = 1;
        }
    }
    int cells() const { return columns_ - 1; }
    std::uint32_t corner(int x, int y) const { return corner_.at(x, y); }
    bool is_wet(int x, int y) const { return x < cells() && y < cells() && is_wet_.at(x, y) != 0; }
    bool is_all(const Leaf& leaf, bool wet) const {
        for (int y = leaf.y; y < leaf.y + leaf.cells; ++y)
            for (int x = leaf.x; x < leaf.x + leaf.cells; ++x)
                if (is_wet(x, y) != wet) return false;
        return true;
    }
    // Wet all over, and nowhere further from what its corners span.
    bool is_even(const Leaf& leaf, float within_m, float within_m_s) const {
        if (!is_all(leaf, true)) return false;
        const int n = leaf.cells;
        const auto at = [&](int x, int y) { return corner(leaf.x + x, leaf.y + y); };
        const std::array<std::uint32_t, 4> c{at(0, 0), at(n, 0), at(0, n), at(n, n)};
        for (int y = 0; y <= n; ++y) {
            for (int x = 0; x <= n; ++x) {
                const float tx = static_cast<float>(x) / static_cast<float>(n);
                const float ty = static_cast<float>(y) / static_cast<float>(n);
                const auto spanned = [&](const auto& of) {
                    return glm::mix(glm::mix(of(c[0]), of(c[1]), tx), glm::mix(of(c[2]), of(c[3]), tx), ty);
                };
                const float height_m = spanned([&](std::uint32_t i) { return mesh_.positions_m[i].y; });
                const glm::vec2 current = spanned([&](std::uint32_t i) { return mesh_.texcoords[i]; });
                const std::uint32_t own = at(x, y);
                if (std::abs(mesh_.positions_m[own].y - height_m) > within_m) return false;
                if (glm::distance(mesh_.texcoords[own], current) > within_m_s) return false;
            }
        }
        return true;
    }

  private:
    const mesh::Mesh& mesh_;
    int columns_;
    mesh::Grid<std::uint32_t> corner_;
    mesh::Grid<std::uint8_t> is_wet_;
};

struct Limits {
    int cells;  // a side of a leaf
    float height_m;
    float current_m_s;
};

Limits limits_of(std::size_t level) {
    // A quarter of a pixel; and so little more or less current that ripples do not show it.
    const float height_m = std::max(0.0005F * WaterLevels::kFrom_m[level], 0.002F);
    return {2 << level, height_m, 0.15F + 0.002F * WaterLevels::kFrom_m[level]};
}

void divide(const Surface& surface, const Leaf& leaf, const Limits& limits, std::vector<Leaf>& leaves) {
    if (surface.is_all(leaf, false)) return;
    const bool is_whole = leaf.cells <= limits.cells && surface.is_even(leaf, limits.height_m, limits.current_m_s);
    if (leaf.cells == 1 || is_whole) {
        leaves.push_back(leaf);
        return;
    }
    const int half = leaf.cells / 2;
    for (const int y : {leaf.y, leaf.y + half})
        for (const int x : {leaf.x, leaf.x + half}) divide(surface, {x, y, half}, limits, leaves);
}

using Marks = mesh::Grid<std::uint8_t>;

template <typename Function>
void for_corners(const Leaf& leaf, Function&& function) {
    for (const int y : {leaf.y, leaf.y + leaf.cells})
        for (const int x : {leaf.x, leaf.x + leaf.cells}) function(x, y);
}

bool is_on_rim(int x, int y) { return x % WaterLevels::kSquare == 0 || y % WaterLevels::kSquare == 0; }

using Corner = glm::ivec2;

// A leaf's edge along one of its sides, counter-clockwise from above: of all corners on it those that are marked.
void add_side(const Surface& surface, const Leaf& leaf, std::size_t side, const Marks& marked,
              std::vector<std::uint32_t>& indices) {
    const int n = leaf.cells;
    const auto along = [&](int i) -> Corner {
        const Corner from_leaf[4] = {{0, i}, {i, n}, {n, n - i}, {n - i, 0}};
        return Corner{leaf.x, leaf.y} + from_leaf[side];
    };
    const std::uint32_t middle = surface.corner(leaf.x + n / 2, leaf.y + n / 2);
    Corner before = along(0);
    for (int i = 1; i <= n; ++i) {
        const Corner at = along(i);
        if (i < n && marked.at(at.x, at.y) == 0) continue;
        indices.insert(indices.end(), {middle, surface.corner(before.x, before.y), surface.corner(at.x, at.y)});
        before = at;
    }
}

bool is_at_side(const Leaf& leaf, std::size_t side) {
    const int square = WaterLevels::kSquare;
    const int place[4] = {leaf.x, leaf.y + leaf.cells, leaf.x + leaf.cells, leaf.y};
    return leaf.cells > 1 && place[side] % square == 0;
}

}  // namespace

// The water's squares, divided for each level, and the corners of its leaves.
struct WaterLevels::Cut {
    const Surface& surface;
    std::vector<std::array<std::vector<Leaf>, kLevels>> leaves;
    std::vector<glm::ivec2> places;  // of the squares, in squares
    Marks finest;                    // on the rims
    Marks of_level;
};

WaterLevels::WaterLevels(const mesh::Mesh& surface_mesh, float cell_m, int columns) {
    if (surface_mesh.indices.empty()) return;
    const Surface surface(surface_mesh, cell_m, columns);
    Cut cut{surface, {}, {}, {}, {}};
    for (int y = 0; y < surface.cells(); y += kSquare) {
        for (int x = 0; x < surface.cells(); x += kSquare) {
            std::array<std::vector<Leaf>, kLevels> leaves;
            for (std::size_t level = 0; level < kLevels; ++level)
                divide(surface, {x, y, kSquare}, limits_of(level), leaves[level]);
            if (leaves.front().empty()) continue;
            cut.leaves.push_back(std::move(leaves));
            cut.places.emplace_back(x / kSquare, y / kSquare);
        }
    }
    cut.finest = Marks(columns, columns, 0);
    for (const auto& leaves : cut.leaves)
        for (const Leaf& leaf : leaves.front())
            for_corners(leaf, [&](int x, int y) { cut.finest.at(x, y) = is_on_rim(x, y) ? 1 : 0; });
    squares_.resize(cut.leaves.size(), {{}, {}, glm::vec3{1e9F}, glm::vec3{-1e9F}});
    // One level after the other, so that neighbours of one level lie side by side.
    for (std::size_t level = 0; level < kLevels; ++level) {
        cut.of_level = Marks(columns, columns, 0);
        for (const auto& leaves : cut.leaves)
            for (const Leaf& leaf : leaves[level]) for_corners(leaf, [&](int x, int y) { cut.of_level.at(x, y) = 1; });
        for (std::size_t i = 0; i < squares_.size(); ++i) add_square(cut, i, level);
        for (std::size_t i = 0; i < squares_.size(); ++i) add_finest_sides(cut, i, level);
    }
    for (std::size_t i = 0; i < squares_.size(); ++i) {
        constexpr glm::ivec2 kWay[kSides] = {{-1, 0}, {0, 1}, {1, 0}, {0, -1}};
        for (std::size_t side = 0; side < kSides; ++side) {
            const auto found = std::ranges::find(cut.places, cut.places[i] + kWay[side]);
            const bool is_there = found != cut.places.end();
            squares_[i].neighbours[side] = is_there ? static_cast<std::size_t>(found - cut.places.begin()) : kNone;
        }
    }
    for (Square& square : squares_) {
        const auto include = [&](const Range& range) {
            for (std::size_t i = range.first; i < range.first + range.count; ++i) {
                square.low_m = glm::min(square.low_m, surface_mesh.positions_m[indices_[i]]);
                square.high_m = glm::max(square.high_m, surface_mesh.positions_m[indices_[i]]);
            }
        };
        include(square.levels.front().within);
        for (const Range& side : square.levels.front().alike) include(side);
    }
}

// A single cell's edges end in no other corners on any level.
void WaterLevels::add_square(const Cut& cut, std::size_t square, std::size_t level) {
    const std::vector<Leaf>& leaves = cut.leaves[square][level];
    Level& to = squares_[square].levels[level];
    const auto added = [this](std::size_t first) { return Range{first, indices_.size() - first}; };
    const bool is_as_before = level > 0 && leaves.size() == cut.leaves[square][level - 1].size();
    if (is_as_before) {
        to.within = squares_[square].levels[level - 1].within;  // nothing left to merge
    } else {
        const std::size_t first = indices_.size();
        for (const Leaf& leaf : leaves) {
            const auto at = [&](int x, int y) { return cut.surface.corner(leaf.x + x, leaf.y + y); };
            if (leaf.cells == 1)
                indices_.insert(indices_.end(), {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)});
            for (std::size_t side = 0; side < kSides && leaf.cells > 1; ++side)
                if (!is_at_side(leaf, side)) add_side(cut.surface, leaf, side, cut.of_level, indices_);
        }
        to.within = added(first);
    }
    for (std::size_t side = 0; side < kSides; ++side) {
        const std::size_t first = indices_.size();
        for (const Leaf& leaf : leaves)
            if (is_at_side(leaf, side)) add_side(cut.surface, leaf, side, cut.of_level, indices_);
        to.alike[side] = added(first);
    }
}

void WaterLevels::add_finest_sides(const Cut& cut, std::size_t square, std::size_t level) {
    const std::vector<Leaf>& leaves = cut.leaves[square][level];
    std::array<Range, kSides>& to = squares_[square].levels[level].finest;
    if (level == 0) {
        to = squares_[square].levels[level].alike;
        return;
    }
    if (leaves.size() == cut.leaves[square][level - 1].size()) {
        to = squares_[square].levels[level - 1].finest;
        return;
    }
    for (std::size_t side = 0; side < kSides; ++side) {
        const std::size_t first = indices_.size();
        for (const Leaf& leaf : leaves)
            if (is_at_side(leaf, side)) add_side(cut.surface, leaf, side, cut.finest, indices_);
        to[side] = {first, indices_.size() - first};
    }
}

std::size_t WaterLevels::level_for(const Square& square, const glm::vec3& eye_m, float nearness) {
    const float away_m = glm::distance(eye_m, glm::clamp(eye_m, square.low_m, square.high_m));
    std::size_t level = 0;
    while (level + 1 < kLevels && away_m >= kFrom_m[level + 1] * nearness) ++level;
    return level;
}

std::vector<Range> WaterLevels::seen(const Frustum& frustum, const glm::vec3& eye_m, float nearness) const {
    std::vector<std::size_t> levels;
    for (const Square& square : squares_) levels.push_back(level_for(square, eye_m, nearness));
    std::vector<Range> ranges;
    const auto add = [&ranges](const Range& range) {
        if (range.count == 0) return;
        if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first)
            ranges.back().count += range.count;
        else
            ranges.push_back(range);
    };
    for (std::size_t i = 0; i < squares_.size(); ++i) {
        const Square& square = squares_[i];
        if (!frustum.may_see_box(square.low_m, square.high_m)) continue;
        const Level& level = square.levels[levels[i]];
        add(level.within);
        for (std::size_t side = 0; side < kSides; ++side) {
            const std::size_t neighbour = square.neighbours[side];
            const bool is_alike = neighbour == kNone || levels[neighbour] == levels[i];
            add(is_alike ? level.alike[side] : level.finest[side]);
        }
    }
    return ranges;
}

}  // namespace quadrat::render::passes
