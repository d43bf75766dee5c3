// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/mesh.hpp"
#include "mesh/straight_skeleton.hpp"

namespace quadrat::mesh {

// Triangles of some of a roof's faces, y up, the plan's y away from the viewer (-z), flat-shaded. texcoords: metres
// along the edge, and up the slope. Faces whose course is not the one asked for are left out; kAllCourses: all of them.
constexpr int kAllCourses = -1;
Mesh roof_mesh(const Roof& roof, int course = kAllCourses);
// What closes it where it was ended.
Mesh top_mesh(const Roof& roof);

// Triangles into roof.vertices, counter-clockwise as the face is.
std::vector<std::uint32_t> face_triangles(const Roof& roof, const RoofFace& face);

}  // namespace quadrat::mesh
