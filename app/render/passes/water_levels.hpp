// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/mesh.hpp"
#include "render/passes/frustum.hpp"
#include "render/passes/ranges.hpp"

namespace quadrat::render::passes {

// The surface of lakes and rivers, cut into squares of the land's grid, each at five levels: where water is level and
// runs alike, its cells are merged in a quadtree, into larger ones the farther away the level is meant for. Every level
// ends at a square's rim in the same corners, so that neighbours of any levels meet without a crack.
class WaterLevels {
  public:
    static constexpr int kSquare = 64;  // cells a side
    static constexpr std::size_t kLevels = 5;
    // m: from here on a level is fine enough where a radian has so many pixels. Corners are where air, mirrored sky and
    // glitter are worked out, so what is near has many.
    static constexpr float kPixelsPerRadian = 500;
    static constexpr std::array<float, kLevels> kFrom_m{0, 30, 70, 150, 300};

    WaterLevels() = default;
    // surface: two triangles a cell, over cells of a grid of this many columns about the origin; texture coordinates
    // are its current in m/s.
    WaterLevels(const mesh::Mesh& surface, float cell_m, int columns);

    // Of all levels, once.
    std::vector<std::uint32_t> take_indices() { return std::move(indices_); }

    // What may be seen. nearness: scales the distances; 1, or less where less is asked for.
    std::vector<Range> seen(const Frustum& frustum, const glm::vec3& eye_m, float nearness) const;

  private:
    struct Square {
        std::array<Range, kLevels> levels;
        glm::vec3 low_m;
        glm::vec3 high_m;
    };
    std::vector<Square> squares_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace quadrat::render::passes
