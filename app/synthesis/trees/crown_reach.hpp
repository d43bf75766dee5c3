// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/mesh.hpp"

namespace quadrat::synthesis::trees {

// How far from the root a crown reaches. No level of it may reach farther: it would be cut off at the edge of what is
// taken for the plant.
inline float reach_m(const mesh::Mesh& mesh) {
    float reach = 0;
    for (const glm::vec3& at_m : mesh.positions_m) reach = std::max(reach, glm::length(at_m));
    return reach;
}

// Drawn in towards the root, where it lies beyond.
inline glm::vec3 within(const glm::vec3& at_m, float reach_m) {
    return at_m * std::min(reach_m / std::max(glm::length(at_m), 1e-3F), 1.0F);
}

}  // namespace quadrat::synthesis::trees
