// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/mesh.hpp"

namespace quadrat::mesh {

// A sphere of radius 1 with hills and hollows at every scale, as scanned things have them: what simplifiers are
// measured on. An octahedron of so many edges a side, 4 edges² + 2 vertices; closed, with normals.
Mesh displaced_sphere(int edges, base::Seed seed);

}  // namespace quadrat::mesh
