// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/choose/frustum.hpp"
#include "render/choose/horizon.hpp"
#include "render/choose/reach.hpp"
#include "scene/land.hpp"

namespace quadrat::render::choose {

// Stone, a piece at a time: what hangs together is one. Each is drawn as finely as it is large on the screen, and not
// at all where it would be less than a pixel.
class Pieces {
  public:
    struct Corner {  // of a flat facet
        glm::vec3 at_m{0};
        glm::vec3 normal{0, 1, 0};
        glm::vec3 colour{0};  // linear
    };

    Pieces() = default;
    explicit Pieces(const scene::Stone& stone);

    // Three a facet, the given stone's first and then the coarser forms; no more than most_corners(). Once.
    std::vector<Corner> take_corners() { return std::move(corners_); }
    static std::size_t most_corners(const scene::Stone& stone) { return 2 * stone.mesh.indices.size(); }

    struct Wish {
        glm::vec3 eye_m{0};
        float pixels_per_radian = 500;
        float error_px = 1;
        const Horizon* horizon = nullptr;  // of the ground before them; null: none
        Reach reach = {};
    };
    // Appends the corners of what may be seen, three a triangle.
    void select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;

  private:
    struct Level {
        std::uint32_t first = 0;  // corner
        std::uint32_t count = 0;
        float error_m = 0;
    };
    struct Piece {
        glm::vec3 middle_m{0};
        float radius_m = 0;
        std::uint32_t first_level = 0, levels = 0;  // finest first
    };
    static bool is_hidden(const Piece& piece, const Horizon* horizon);
    void add_piece(const scene::Stone& stone, std::span<const std::uint32_t> triangles);
    void add_coarser(const scene::Stone& stone, std::span<const std::uint32_t> triangles);

    std::vector<Corner> corners_;
    std::vector<Level> levels_;
    std::vector<Piece> pieces_;
};

}  // namespace quadrat::render::choose
