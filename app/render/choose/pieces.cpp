// SPDX-License-Identifier: Apache-2.0
#include "render/choose/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "mesh/pieces.hpp"
#include "mesh/progressive.hpp"

namespace quadrat::render::choose {
namespace {

constexpr float kLeast_px = 0.7F;  // of a radius: what is smaller is not missed
// The error of a level is a mean over its dearest collapse; a silhouette differs by more.
constexpr float kSilhouette = 2.5F;

}  // namespace

Pieces::Pieces(const scene::Stone& stone) {
    // Of a piece the corners lie side by side; the coarser forms come after all of them.
    const auto pieces = mesh::pieces_of(stone.mesh);
    std::vector<std::uint32_t> firsts;
    for (const auto& triangles : pieces) {
        firsts.push_back(static_cast<std::uint32_t>(corners_.size()));
        for (const std::uint32_t first : triangles) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t index = stone.mesh.indices[first + k];
                corners_.push_back({stone.mesh.positions_m[index], stone.mesh.normals[index], stone.colours[index]});
            }
        }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        pieces_.push_back({{}, 0, static_cast<std::uint32_t>(levels_.size()), 1});
        levels_.push_back({firsts[i], 3 * static_cast<std::uint32_t>(pieces[i].size()), 0});
        add_piece(stone, pieces[i]);
    }
}

void Pieces::add_piece(const scene::Stone& stone, std::span<const std::uint32_t> triangles) {
    Piece& piece = pieces_.back();
    glm::vec3 low = stone.mesh.positions_m[stone.mesh.indices[triangles.front()]];
    glm::vec3 high = low;
    for (const std::uint32_t first : triangles) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::vec3 at_m = stone.mesh.positions_m[stone.mesh.indices[first + k]];
            low = glm::min(low, at_m);
            high = glm::max(high, at_m);
        }
    }
    piece.middle_m = 0.5F * (low + high);
    piece.radius_m = 0.5F * glm::distance(low, high);
    add_coarser(stone, triangles);
}

void Pieces::add_coarser(const scene::Stone& stone, std::span<const std::uint32_t> triangles) {
    constexpr std::size_t kColour = 3;
    mesh::Mesh whole;
    std::vector<float> colours;
    std::map<std::tuple<float, float, float>, std::uint32_t> at;
    for (const std::uint32_t first : triangles) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t index = stone.mesh.indices[first + k];
            const glm::vec3 p = stone.mesh.positions_m[index];
            const auto [found, is_new] =
                at.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(whole.positions_m.size()));
            if (is_new) {
                whole.positions_m.push_back(p);
                const glm::vec3 c = stone.colours[index];
                colours.insert(colours.end(), {c.r, c.g, c.b});
            }
            whole.indices.push_back(found->second);
        }
    }
    mesh::ProgressiveOptions options;
    options.fewest = 6;
    options.attributes = colours;
    options.attributes_a_vertex = kColour;
    const mesh::Progressive coarser = mesh::make_progressive(whole, options);
    for (std::size_t level = 1; level < coarser.levels.size(); ++level) {
        const mesh::Progressive::Level& from = coarser.levels[level];
        if (corners_.size() + from.mesh.indices.size() > most_corners(stone)) return;
        const auto first = static_cast<std::uint32_t>(corners_.size());
        for (std::size_t i = 0; i + 2 < from.mesh.indices.size(); i += 3) {
            std::array<glm::vec3, 3> corner{};
            for (std::size_t k = 0; k < 3; ++k) corner[k] = from.mesh.positions_m[from.mesh.indices[i + k]];
            const glm::vec3 across = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
            const float area2 = glm::length(across);
            if (area2 <= 0) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const float* c = &from.attributes[kColour * from.mesh.indices[i + k]];
                corners_.push_back({corner[k], across / area2, {c[0], c[1], c[2]}});
            }
        }
        levels_.push_back({first, static_cast<std::uint32_t>(corners_.size()) - first, kSilhouette * from.error_m});
        ++pieces_.back().levels;
    }
}

bool Pieces::is_hidden(const Piece& piece, const Horizon* horizon) {
    return horizon && horizon->hides_standing({piece.middle_m.x, piece.middle_m.z}, piece.radius_m,
                                              piece.middle_m.y + piece.radius_m);
}

void Pieces::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    for (const Piece& piece : pieces_) {
        const float distance_m = std::max(glm::distance(piece.middle_m, wish.eye_m) - piece.radius_m, 0.5F);
        const float px_per_m = wish.pixels_per_radian / distance_m;
        if (piece.radius_m * px_per_m < kLeast_px * wish.error_px) continue;
        if (!wish.reach.may_hold_sphere(piece.middle_m, piece.radius_m)) continue;
        if (!frustum.may_see_sphere(piece.middle_m, piece.radius_m)) continue;
        if (is_hidden(piece, wish.horizon)) continue;
        const Level* level = &levels_[piece.first_level];
        for (std::uint32_t coarser = 1; coarser < piece.levels; ++coarser)
            if (level[1].error_m * px_per_m <= wish.error_px) ++level;
        const std::size_t end = indices.size();
        indices.resize(end + level->count);
        std::iota(indices.begin() + static_cast<std::ptrdiff_t>(end), indices.end(), level->first);
    }
}

}  // namespace quadrat::render::choose
