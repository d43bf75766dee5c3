// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/choose/frustum.hpp"
#include "render/choose/horizon.hpp"
#include "render/choose/reach.hpp"
#include "scene/settlement.hpp"

namespace quadrat::render::choose {

// What is sent of a settlement's houses, house by house and level by level. The finest level is sent of as many as a
// viewer in the south could come near.
struct SentLevel {
    std::size_t house;
    std::size_t level;
};
std::vector<SentLevel> sent_levels(const scene::Settlement& settlement);

// Which houses are drawn, and how closely: each by how large it is on the screen.
class HouseLevels {
  public:
    HouseLevels() = default;
    // Counts corners in the order of sent_levels(), then those of the bounds.
    explicit HouseLevels(const scene::Settlement& settlement);

    struct Wish {
        glm::vec3 eye_m{0};
        float pixels_per_radian = 500;
        float fineness = 1;                // 2: as finely from twice as far
        float standing = 1;                // the share of the houses that are built, the oldest first
        const Horizon* horizon = nullptr;  // of the ground before them; null: none
        Reach reach = {};
    };
    // Appends the corners of what may be seen, three a triangle.
    void select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const;

  private:
    struct Level {
        std::uint32_t first = 0;  // corner
        std::size_t list = 0;     // of indices from there
    };
    struct Standing {
        glm::vec3 middle_m{0};
        float radius_m = 0;
        std::vector<Level> levels;  // finest first
        std::size_t finest = 2;     // of them, in the building's numbering
    };
    std::vector<std::vector<std::uint32_t>> indices_;
    std::vector<Standing> standing_;
};

}  // namespace quadrat::render::choose
