// SPDX-License-Identifier: Apache-2.0
// CGAL's part, in a file of its own: its headers want other compiler options than ours.
#pragma once
#include <cstddef>

#include "mesh/mesh.hpp"
#include "mesh/straight_skeleton.hpp"

namespace quadrat::peers {

const char* why_no_cgal();  // "" where it was built in; otherwise the two below do nothing

// The mesh with so many vertices, about; says how many it has. The mesh must be closed.
std::size_t simplified_by_cgal(const mesh::Mesh& mesh, std::size_t vertices);
// How many nodes the interior skeleton of the plan's outer loop has. The loop must turn counter-clockwise.
std::size_t skeleton_by_cgal(const mesh::Plan& plan);

}  // namespace quadrat::peers
