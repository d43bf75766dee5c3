// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace quadrat::mesh {

// The pieces that a mesh falls into, each as the first indices of its triangles, in their order; pieces in the order
// of their first triangles. Vertices at one place are one: facets with corners of their own hang together.
std::vector<std::vector<std::uint32_t>> pieces_of(const Mesh& mesh);

}  // namespace quadrat::mesh
