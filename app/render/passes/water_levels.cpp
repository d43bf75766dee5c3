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

constexpr std::uint32_t kNone = 0xFFFF'FFFF;

// A square of cells that is drawn as one.
struct Leaf {
    int x, y, cells;
};

class Surface {
  public:
    Surface(const mesh::Mesh& mesh, float cell_m, int columns)
        : mesh_(mesh), columns_(columns), corner_(columns, columns, kNone), is_wet_(columns, columns, 0) {
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

// Counter-clockwise from above, as the surface's own: around its middle to every corner on its edges, or two triangles.
void add_triangles(const Surface& surface, const Leaf& leaf, const Marks& corners,
                   std::vector<std::uint32_t>& indices) {
    const int n = leaf.cells;
    const auto at = [&](int x, int y) { return surface.corner(leaf.x + x, leaf.y + y); };
    if (n == 1) {
        indices.insert(indices.end(), {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)});
        return;
    }
    std::vector<std::uint32_t> edge;
    const auto add = [&](int x, int y) {
        if (corners.at(leaf.x + x, leaf.y + y) != 0) edge.push_back(at(x, y));
    };
    for (int i = 0; i < n; ++i) add(0, i);
    for (int i = 0; i < n; ++i) add(i, n);
    for (int i = n; i > 0; --i) add(n, i);
    for (int i = n; i > 0; --i) add(i, 0);
    const std::uint32_t middle = at(n / 2, n / 2);
    for (std::size_t i = 0; i < edge.size(); ++i)
        indices.insert(indices.end(), {middle, edge[i], edge[(i + 1) % edge.size()]});
}

}  // namespace

WaterLevels::WaterLevels(const mesh::Mesh& surface_mesh, float cell_m, int columns) {
    if (surface_mesh.indices.empty()) return;
    const Surface surface(surface_mesh, cell_m, columns);
    std::vector<std::array<std::vector<Leaf>, kLevels>> divided;  // for each square
    for (int y = 0; y < surface.cells(); y += kSquare) {
        for (int x = 0; x < surface.cells(); x += kSquare) {
            std::array<std::vector<Leaf>, kLevels> leaves;
            for (std::size_t level = 0; level < kLevels; ++level)
                divide(surface, {x, y, kSquare}, limits_of(level), leaves[level]);
            if (!leaves.front().empty()) divided.push_back(std::move(leaves));
        }
    }
    // The finest level's corners on a rim are those of every level.
    Marks rims(columns, columns, 0);
    for (const auto& leaves : divided)
        for (const Leaf& leaf : leaves.front())
            for_corners(leaf, [&](int x, int y) { rims.at(x, y) = is_on_rim(x, y) ? 1 : 0; });
    squares_.resize(divided.size(), {{}, glm::vec3{1e9F}, glm::vec3{-1e9F}});
    // One level after the other, so that neighbours of one level lie side by side.
    for (std::size_t level = 0; level < kLevels; ++level) {
        Marks corners = rims;
        for (const auto& leaves : divided)
            for (const Leaf& leaf : leaves[level]) for_corners(leaf, [&](int x, int y) { corners.at(x, y) = 1; });
        for (std::size_t i = 0; i < divided.size(); ++i) {
            const std::vector<Leaf>& leaves = divided[i][level];
            auto& levels = squares_[i].levels;
            if (level > 0 && leaves.size() == divided[i][level - 1].size()) {
                levels[level] = levels[level - 1];  // nothing left to merge
                continue;
            }
            levels[level].first = indices_.size();
            for (const Leaf& leaf : leaves) add_triangles(surface, leaf, corners, indices_);
            levels[level].count = indices_.size() - levels[level].first;
        }
    }
    for (Square& square : squares_) {
        const Range& finest = square.levels.front();
        for (std::size_t i = finest.first; i < finest.first + finest.count; ++i) {
            square.low_m = glm::min(square.low_m, surface_mesh.positions_m[indices_[i]]);
            square.high_m = glm::max(square.high_m, surface_mesh.positions_m[indices_[i]]);
        }
    }
}

std::vector<Range> WaterLevels::seen(const Frustum& frustum, const glm::vec3& eye_m, float nearness) const {
    std::vector<Range> ranges;
    for (const Square& square : squares_) {
        if (!frustum.may_see_box(square.low_m, square.high_m)) continue;
        const float away_m = glm::distance(eye_m, glm::clamp(eye_m, square.low_m, square.high_m));
        std::size_t level = 0;
        while (level + 1 < kLevels && away_m >= kFrom_m[level + 1] * nearness) ++level;
        const Range& range = square.levels[level];
        if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first)
            ranges.back().count += range.count;
        else
            ranges.push_back(range);
    }
    return ranges;
}

}  // namespace quadrat::render::passes
