// SPDX-License-Identifier: Apache-2.0
#include "mesh/displaced_sphere.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/value_noise.hpp"

namespace quadrat::mesh {
namespace {

float radius(glm::vec3 toward, base::Seed seed) {
    float height = 0;
    float amplitude = 0.101F;
    glm::vec3 at = 2.1F * toward;
    for (std::uint64_t octave = 0; octave < 7; ++octave) {
        height += amplitude * value_noise(at, seed.child(octave));
        at *= 2.0F;
        amplitude *= 0.5F;
    }
    return 1 + height;
}

// The lattice points with |x| + |y| + |z| = edges, each once.
class Octahedron {
  public:
    explicit Octahedron(int edges)
        : edges_(edges),
          known_(2 * static_cast<std::size_t>(2 * edges + 1) * static_cast<std::size_t>(2 * edges + 1), -1) {
        for (int octant = 0; octant < 8; ++octant) {
            for (int x = 0; x < edges; ++x) {
                for (int y = 0; y < edges - x; ++y) {
                    add(octant, {x, y}, {x + 1, y}, {x, y + 1});
                    if (x + y + 2 <= edges) add(octant, {x + 1, y}, {x + 1, y + 1}, {x, y + 1});
                }
            }
        }
    }
    std::vector<glm::vec3> points;
    std::vector<std::uint32_t> indices;

  private:
    void add(int octant, glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
        const int mirrored = (octant ^ (octant >> 1) ^ (octant >> 2)) & 1;
        if (mirrored != 0) std::swap(b, c);
        for (const glm::ivec2 p : {a, b, c}) indices.push_back(vertex(octant, p));
    }

    std::uint32_t vertex(int octant, glm::ivec2 p) {
        const int x = (octant & 1) != 0 ? -p.x : p.x;
        const int y = (octant & 2) != 0 ? -p.y : p.y;
        const int depth = edges_ - p.x - p.y;
        const int z = (octant & 4) != 0 ? -depth : depth;
        const int wide = 2 * edges_ + 1;
        int& known = known_[static_cast<std::size_t>(((z < 0 ? 1 : 0) * wide + y + edges_) * wide + x + edges_)];
        if (known < 0) {
            known = static_cast<int>(points.size());
            points.emplace_back(x, y, z);
        }
        return static_cast<std::uint32_t>(known);
    }

    int edges_;
    std::vector<int> known_;
};

}  // namespace

Mesh displaced_sphere(int edges, base::Seed seed) {
    Octahedron lattice(edges);
    Mesh mesh;
    mesh.indices = std::move(lattice.indices);
    mesh.normals.resize(lattice.points.size(), glm::vec3{0});
    for (const glm::vec3& p : lattice.points) {
        const glm::vec3 toward = glm::normalize(p);
        mesh.positions_m.push_back(toward * radius(toward, seed));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions_m[mesh.indices[i]];
        const glm::vec3 b = mesh.positions_m[mesh.indices[i + 1]];
        const glm::vec3 c = mesh.positions_m[mesh.indices[i + 2]];
        for (std::size_t k = 0; k < 3; ++k) mesh.normals[mesh.indices[i + k]] += glm::cross(b - a, c - a);
    }
    for (glm::vec3& n : mesh.normals) n = glm::normalize(n);
    return mesh;
}

}  // namespace quadrat::mesh
