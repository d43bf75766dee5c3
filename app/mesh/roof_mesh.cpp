// SPDX-License-Identifier: Apache-2.0
#include "mesh/roof_mesh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangulate.hpp"

namespace quadrat::mesh {
namespace {

using Loop = std::vector<std::uint32_t>;

// Twice the area of a loop as a vector along its normal.
glm::dvec3 area_vector(const Roof& roof, const Loop& loop) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += glm::cross(roof.vertices[loop[i]] - roof.vertices[loop[0]],
                          roof.vertices[loop[(i + 1) % loop.size()]] - roof.vertices[loop[0]]);
    return sum;
}

// Along the edge, and up the slope; for the plane that has this normal.
struct Frame {
    glm::dvec3 along, up;
    explicit Frame(glm::dvec3 normal) {
        const glm::dvec2 level(-normal.y, normal.x);
        const double length = glm::length(level);
        along = length > 1.0e-12 ? glm::dvec3(level / length, 0.0) : glm::dvec3(1, 0, 0);
        up = glm::cross(normal, along);
    }
    glm::dvec2 operator()(glm::dvec3 p) const { return {glm::dot(along, p), glm::dot(up, p)}; }
};

Loop triangles_in(const Roof& roof, const Frame& frame, const Loop& outline, const std::vector<Loop>& holes) {
    std::vector<glm::dvec2> flat;
    Loop original;
    const auto enter = [&](const Loop& loop) {
        Loop numbers;
        for (const std::uint32_t v : loop) {
            numbers.push_back(static_cast<std::uint32_t>(flat.size()));
            flat.push_back(frame(roof.vertices[v]));
            original.push_back(v);
        }
        return numbers;
    };
    const Loop outer = enter(outline);
    std::vector<Loop> inner;
    for (const Loop& hole : holes) inner.push_back(enter(hole));
    Loop triangles = triangulate(flat, outer, inner);
    for (std::uint32_t& index : triangles) index = original[index];
    return triangles;
}

void append(Mesh& mesh, const Roof& roof, const Loop& triangles, const Frame& frame, glm::dvec3 normal) {
    for (const std::uint32_t v : triangles) {
        const glm::dvec3 p = roof.vertices[v];
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions_m.size()));
        mesh.positions_m.emplace_back(p.x, p.z, -p.y);
        mesh.normals.emplace_back(normal.x, normal.z, -normal.y);
        mesh.texcoords.emplace_back(frame(p));
    }
}

}  // namespace

Loop face_triangles(const Roof& roof, const RoofFace& face) {
    const glm::dvec3 area = area_vector(roof, face.outline);
    if (!(glm::length(area) > 0)) return {};
    return triangles_in(roof, Frame(glm::normalize(area)), face.outline, face.holes);
}

Mesh roof_mesh(const Roof& roof, int course) {
    Mesh mesh;
    for (const RoofFace& face : roof.faces) {
        if (course != kAllCourses && face.course != course) continue;
        const glm::dvec3 area = area_vector(roof, face.outline);
        if (!(glm::length(area) > 0)) continue;
        const glm::dvec3 normal = glm::normalize(area);
        append(mesh, roof, face_triangles(roof, face), Frame(normal), normal);
    }
    return mesh;
}

Mesh top_mesh(const Roof& roof) {
    Mesh mesh;
    const glm::dvec3 up(0, 0, 1);
    std::vector<Loop> holes;
    for (const Loop& top : roof.tops)
        if (area_vector(roof, top).z < 0) holes.push_back(top);
    const auto is_inside = [&roof](const Loop& hole, const Loop& top) {
        const glm::dvec3 p = roof.vertices[hole.front()];
        bool is_in = false;
        for (std::size_t i = 0; i < top.size(); ++i) {
            const glm::dvec3 a = roof.vertices[top[i]];
            const glm::dvec3 b = roof.vertices[top[(i + 1) % top.size()]];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) is_in = !is_in;
        }
        return is_in;
    };
    for (const Loop& top : roof.tops) {
        if (area_vector(roof, top).z <= 0) continue;
        std::vector<Loop> own;
        for (const Loop& hole : holes)
            if (is_inside(hole, top)) own.push_back(hole);
        append(mesh, roof, triangles_in(roof, Frame(up), top, own), Frame(up), up);
    }
    return mesh;
}

}  // namespace quadrat::mesh
