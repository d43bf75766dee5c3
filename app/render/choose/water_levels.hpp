// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/mesh.hpp"
#include "render/choose/frustum.hpp"
#include "render/choose/ranges.hpp"
#include "render/choose/reach.hpp"

namespace quadrat::render::choose {

// The surface of lakes and rivers, cut into squares of the land's grid, each at several levels: where water is level
// and runs alike, its cells are merged in a quadtree, into larger ones the farther away the level is meant for. Coarse
// levels go on under the banks, where the land hides them: a shore is the land's line, not the water's. In the water
// every level ends at a square's rim in the same corners, so that neighbours of any levels meet without a crack.
class WaterLevels {
  public:
    static constexpr int kSquare = 64;  // cells a side
    static constexpr std::size_t kLevels = 7;
    static constexpr std::size_t kUnderBanksFrom = 2;  // the first level that is wider than the water
    // m: from here on a level is fine enough where a radian has so many pixels. Corners are where air, mirrored sky and
    // glitter are worked out, so what is near has many.
    static constexpr float kPixelsPerRadian = 500;
    static constexpr std::array<float, kLevels> kFrom_m{0, 30, 70, 150, 300, 700, 1500};

    WaterLevels() = default;
    // surface: two triangles a cell of land_m, whose samples lie cell_m apart about the origin; texture coordinates are
    // its current in m/s.
    WaterLevels(const mesh::Mesh& surface, const mesh::Field& land_m, float cell_m);

    // Of all levels, once: they count the surface's vertices and after them the banks'.
    std::vector<std::uint32_t> take_indices() { return std::move(indices_); }

    // A corner under a bank, and the surface's vertex whose current it has.
    struct Bank {
        glm::vec3 at_m;
        std::uint32_t like;
    };
    // Once; no more than most_banks() of that surface.
    std::vector<Bank> take_banks() { return std::move(banks_); }
    static std::size_t most_banks(const mesh::Mesh& surface) {
        return std::min<std::size_t>(surface.positions_m.size() / 4, 4096);
    }

    // What may be seen. nearness: scales the distances; 1, or less where less is asked for.
    std::vector<Range> seen(const Frustum& frustum, const glm::vec3& eye_m, float nearness,
                            const Reach& reach = {}) const;

  private:
    struct Square {
        std::array<Range, kLevels> levels;
        glm::vec3 low_m;
        glm::vec3 high_m;
    };
    std::vector<Square> squares_;
    std::vector<std::uint32_t> indices_;
    std::vector<Bank> banks_;
};

}  // namespace quadrat::render::choose
