// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/sparse_field.hpp"

namespace quadrat::mesh {

// A closed 2-manifold about what is inside, counter-clockwise seen from outside.
struct Surface {
    std::vector<glm::vec3> positions;  // in samples
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> blocks;  // a vertex: the block its cell belongs to
};
Surface polygonise(const SparseField& field);

}  // namespace quadrat::mesh
