// SPDX-License-Identifier: Apache-2.0
#include "render/choose/water_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/ext/vector_int2.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <unordered_map>
#include <utility>

#include "mesh/field.hpp"

namespace quadrat::render::choose {
namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFF;
constexpr std::uint32_t kBank = 0x8000'0000;  // beside the vertex whose level and current a corner under a bank has
constexpr int kBankCells = 16;                // so far from the water banks are looked at

// A square of cells that is drawn as one.
struct Leaf {
    int x, y, cells;
};

class Surface {
  public:
    Surface(const mesh::Mesh& mesh, const mesh::Field& land_m, float cell_m)
        : mesh_(mesh),
          land_m_(land_m),
          cell_m_(cell_m),
          half_(0.5F * static_cast<float>(land_m.columns - 1)),
          most_banks_(WaterLevels::most_banks(mesh)),
          corner_(land_m.columns, land_m.rows, kNone),
          is_wet_(land_m.columns, land_m.rows, 0) {
        const auto place = [&](float at_m) { return static_cast<int>(std::lround(at_m / cell_m + half_)); };
        std::vector<glm::ivec2> rim;
        for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
            rim.emplace_back(place(mesh.positions_m[i].x), place(mesh.positions_m[i].z));
            corner_.at(rim.back().x, rim.back().y) = static_cast<std::uint32_t>(i);
        }
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return mesh.positions_m[mesh.indices[i + k]]; };
            const glm::vec3 low_m = glm::min(glm::min(at(0), at(1)), at(2));
            is_wet_.at(place(low_m.x), place(low_m.z)) = 1;
        }
        for (int away = 0; away < kBankCells; ++away) rim = continue_under_banks(rim);
    }
    int cells() const { return land_m_.columns - 1; }
    bool is_wet(int x, int y) const { return x < cells() && y < cells() && is_wet_.at(x, y) != 0; }
    bool is_dry(const Leaf& leaf) const {
        for (int y = leaf.y; y < leaf.y + leaf.cells; ++y)
            for (int x = leaf.x; x < leaf.x + leaf.cells; ++x)
                if (is_wet(x, y)) return false;
        return true;
    }

    struct Tolerance {
        float height_m;
        float current_m_s;
        bool under_banks;
    };
    // Wet, or hidden by the land, all over; and nowhere further from what its corners span.
    bool is_even(const Leaf& leaf, const Tolerance& within) const {
        const int n = leaf.cells;
        const bool under_banks = within.under_banks && !are_banks_full();
        std::array<std::uint32_t, 4> like{};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t corner = corner_.at(leaf.x + (k % 2 == 0 ? 0 : n), leaf.y + (k < 2 ? 0 : n));
            if (corner == kNone || (is_bank(corner) && !under_banks)) return false;
            like[k] = corner & ~kBank;
        }
        const auto spanned = [&](int x, int y, const auto& of) {
            const float tx = static_cast<float>(x) / static_cast<float>(n);
            const float ty = static_cast<float>(y) / static_cast<float>(n);
            return glm::mix(glm::mix(of(like[0]), of(like[1]), tx), glm::mix(of(like[2]), of(like[3]), tx), ty);
        };
        const auto height_m = [&](std::uint32_t i) { return mesh_.positions_m[i].y; };
        const auto current_m_s = [&](std::uint32_t i) { return mesh_.texcoords[i]; };
        for (int y = 0; y <= n; ++y) {
            for (int x = 0; x <= n; ++x) {
                const float level_m = spanned(x, y, height_m);
                const std::uint32_t own = corner_.at(leaf.x + x, leaf.y + y);
                if (own == kNone) return false;  // no vertex could be there
                const float own_m = height_m(own & ~kBank);
                if (std::abs(own_m - level_m) > within.height_m) return false;
                if (!is_bank(own) && glm::distance(current_m_s(own), spanned(x, y, current_m_s)) > within.current_m_s)
                    return false;
                if (under_banks && land_m_.at(leaf.x + x, leaf.y + y) >= std::max(level_m, own_m)) continue;
                // Not hidden: nowhere but in the water.
                for (const int beside_y : {y - 1, y})
                    for (const int beside_x : {x - 1, x}) {
                        const bool is_own = beside_x >= 0 && beside_y >= 0 && beside_x < n && beside_y < n;
                        if (is_own && !is_wet(leaf.x + beside_x, leaf.y + beside_y)) return false;
                    }
            }
        }
        return true;
    }

    // Has vertices for its corners and its middle.
    void take(const Leaf& leaf) {
        for (const int y : {leaf.y, leaf.y + leaf.cells})
            for (const int x : {leaf.x, leaf.x + leaf.cells}) vertex(x, y);
        vertex(leaf.x + leaf.cells / 2, leaf.y + leaf.cells / 2);
    }
    // The surface's own, or one under a bank, new where there is none yet.
    std::uint32_t vertex(int x, int y) {
        const std::uint32_t corner = corner_.at(x, y);
        if (!is_bank(corner)) return corner;
        const auto number = static_cast<std::uint32_t>(mesh_.positions_m.size() + banks_.size());
        const auto [found, is_new] = bank_at_.try_emplace(corner_.index(x, y), number);
        if (is_new) {
            const std::uint32_t like = corner & ~kBank;
            const auto along_m = [&](int at) { return (static_cast<float>(at) - half_) * cell_m_; };
            banks_.push_back({{along_m(x), mesh_.positions_m[like].y, along_m(y)}, like});
        }
        return found->second;
    }
    std::vector<WaterLevels::Bank> take_banks() { return std::move(banks_); }

  private:
    static bool is_bank(std::uint32_t corner) { return corner != kNone && (corner & kBank) != 0; }
    // A leaf takes five at most.
    bool are_banks_full() const { return banks_.size() + 5 > most_banks_; }

    std::vector<glm::ivec2> continue_under_banks(const std::vector<glm::ivec2>& rim) {
        std::vector<glm::ivec2> next;
        for (const glm::ivec2 from : rim) {
            for (int y = from.y - 1; y <= from.y + 1; ++y) {
                for (int x = from.x - 1; x <= from.x + 1; ++x) {
                    if (!corner_.is_inside(x, y) || corner_.at(x, y) != kNone) continue;
                    corner_.at(x, y) = corner_.at(from.x, from.y) | kBank;
                    next.emplace_back(x, y);
                }
            }
        }
        return next;
    }

    const mesh::Mesh& mesh_;
    const mesh::Field& land_m_;
    float cell_m_;
    float half_;
    std::size_t most_banks_;
    mesh::Grid<std::uint32_t> corner_;
    mesh::Grid<std::uint8_t> is_wet_;
    std::unordered_map<std::size_t, std::uint32_t> bank_at_;  // by the corner's index
    std::vector<WaterLevels::Bank> banks_;
};

struct Limits {
    int cells;  // a side of a leaf
    Surface::Tolerance within;
};

Limits limits_of(std::size_t level) {
    // A quarter of a pixel; and so little more or less current that ripples do not show it.
    const float height_m = std::max(0.0005F * WaterLevels::kFrom_m[level], 0.002F);
    return {2 << level,
            {height_m, 0.15F + 0.002F * WaterLevels::kFrom_m[level], level >= WaterLevels::kUnderBanksFrom}};
}

void divide(Surface& surface, const Leaf& leaf, const Limits& limits, std::vector<Leaf>& leaves) {
    if (surface.is_dry(leaf)) return;
    if (leaf.cells == 1 || (leaf.cells <= limits.cells && surface.is_even(leaf, limits.within))) {
        surface.take(leaf);
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
void add_triangles(Surface& surface, const Leaf& leaf, const Marks& corners, std::vector<std::uint32_t>& indices) {
    const int n = leaf.cells;
    const auto at = [&](int x, int y) { return surface.vertex(leaf.x + x, leaf.y + y); };
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

WaterLevels::WaterLevels(const mesh::Mesh& surface_mesh, const mesh::Field& land_m, float cell_m) {
    if (surface_mesh.indices.empty()) return;
    Surface surface(surface_mesh, land_m, cell_m);
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
    Marks rims(land_m.columns, land_m.rows, 0);
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
    banks_ = surface.take_banks();
    for (Square& square : squares_) {
        const Range& finest = square.levels.front();
        for (std::size_t i = finest.first; i < finest.first + finest.count; ++i) {
            square.low_m = glm::min(square.low_m, surface_mesh.positions_m[indices_[i]]);
            square.high_m = glm::max(square.high_m, surface_mesh.positions_m[indices_[i]]);
        }
    }
}

std::vector<Range> WaterLevels::seen(const Frustum& frustum, const glm::vec3& eye_m, float nearness,
                                     const Reach& reach) const {
    std::vector<Range> ranges;
    for (const Square& square : squares_) {
        if (!reach.may_hold_box(square.low_m, square.high_m)) continue;
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

}  // namespace quadrat::render::choose
