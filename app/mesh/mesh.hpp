// SPDX-License-Identifier: Apache-2.0
// The room `mesh`: geometry and pixels. Fields, images, meshes and chains of simpler ones, roofs, lots, models for
// other tools. Nothing here knows of landscapes or of a GPU: numbers go in, numbers come out.
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::mesh {

// Indexed triangles, counter-clockwise seen from outside. Every non-empty attribute has one entry a vertex.
struct Mesh {
    std::vector<glm::vec3> positions_m;
    std::vector<glm::vec3> normals;  // unit length
    std::vector<glm::vec2> texcoords;
    std::vector<std::uint32_t> indices;  // three a triangle

    std::size_t triangle_count() const { return indices.size() / 3; }
    friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace quadrat::mesh
