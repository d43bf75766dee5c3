// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

// What it means for a mesh to be the surface of something solid.
namespace quadrat::tests {

// Empty when every edge is shared by exactly two triangles that run along it in opposite directions, and the triangles
// about every vertex form one fan.
inline std::string manifold_fault(std::span<const std::uint32_t> indices, std::size_t vertices) {
    struct Edge {
        std::uint32_t from, to;
        bool operator<(const Edge& o) const { return from != o.from ? from < o.from : to < o.to; }
        bool operator==(const Edge& o) const { return from == o.from && to == o.to; }
    };
    std::vector<Edge> edges;
    std::vector<std::uint32_t> fans(vertices, 0);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge{indices[i + k], indices[i + (k + 1) % 3]};
            if (edge.from >= vertices || edge.to >= vertices) return "an index beyond the vertices";
            if (edge.from == edge.to) return "a triangle with one corner twice";
            edges.push_back(edge);
            ++fans[edge.from];
        }
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
        return "an edge that two triangles run along the same way";
    for (const Edge& e : edges)
        if (!std::binary_search(edges.begin(), edges.end(), Edge{e.to, e.from}))
            return "an edge with a triangle on one side only";
    // Walk around each vertex: the walk must meet all of its triangles.
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> around(vertices);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            around[indices[i + k]].emplace_back(indices[i + (k + 1) % 3], indices[i + (k + 2) % 3]);
    for (std::size_t v = 0; v < vertices; ++v) {
        if (around[v].empty()) continue;
        std::uint32_t at = around[v].front().first;
        std::size_t met = 0;
        do {
            const auto found = std::ranges::find(around[v], at, &std::pair<std::uint32_t, std::uint32_t>::first);
            if (found == around[v].end()) return "a vertex whose triangles do not close";
            at = found->second;
            ++met;
        } while (at != around[v].front().first && met <= around[v].size());
        if (met != around[v].size()) return "a vertex where two sheets touch";
    }
    return {};
}

inline double volume_of(const mesh::Mesh& mesh) {
    double six = 0;
    const auto& p = mesh.positions_m;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        six += glm::dot(p[mesh.indices[i]], glm::cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
    return six / 6;
}

// Triangles thinner than this share of their longest side, by their height on it.
inline std::size_t degenerate_triangles(const mesh::Mesh& mesh, float thinnest = 1.0e-5F) {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions_m[mesh.indices[i]];
        const glm::vec3 b = mesh.positions_m[mesh.indices[i + 1]];
        const glm::vec3 c = mesh.positions_m[mesh.indices[i + 2]];
        const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        const float twice = glm::length(glm::cross(b - a, c - a));
        if (!(twice > thinnest * longest * longest)) ++count;
    }
    return count;
}

}  // namespace quadrat::tests
