// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <span>

#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// Along a limb, without twist from node to node (parallel transport).
struct TubeFrame {
    glm::vec3 along{0, 1, 0};
    glm::vec3 side{1, 0, 0};
    glm::vec3 up{0, 0, 1};
};

inline TubeFrame frame_along(const glm::vec3& along) {
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    const glm::vec3 side = glm::normalize(glm::cross(other, along));
    return {along, side, glm::cross(along, side)};
}

inline TubeFrame transported(const TubeFrame& before, const glm::vec3& along) {
    const glm::vec3 side = before.side - glm::dot(before.side, along) * along;
    const float length2 = glm::dot(side, side);
    if (length2 < 1.0e-6F) return frame_along(along);
    const glm::vec3 unit = side * (1.0F / std::sqrt(length2));
    return {along, unit, glm::cross(along, unit)};
}

// The direction at a node: of the chord across it.
inline glm::vec3 direction_at(std::span<const Limb::Node> nodes, std::size_t i) {
    const std::size_t a = i == 0 ? 0 : i - 1;
    const std::size_t b = i + 1 < nodes.size() ? i + 1 : i;
    const glm::vec3 d = nodes[b].at_m - nodes[a].at_m;
    const float length2 = glm::dot(d, d);
    return length2 > 1.0e-12F ? d * (1.0F / std::sqrt(length2)) : glm::vec3{0, 1, 0};
}

}  // namespace quadrat::synthesis::trees
