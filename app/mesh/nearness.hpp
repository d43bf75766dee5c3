// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace quadrat::mesh {

// How far points lie from a mesh. Borrows the mesh.
class Nearness {
  public:
    explicit Nearness(const Mesh& mesh);

    // To the nearest point of any triangle, metres; infinite for a mesh without triangles.
    float distance_m(glm::vec3 from_m) const;
    struct Nearest {
        glm::vec3 at_m;
        float distance_m;
        std::uint32_t triangle;
    };
    // The mesh must have triangles. guess: one of them that may be near; the nearer it is, the sooner this ends. slack:
    // the point may be farther than the nearest by this share.
    Nearest nearest(glm::vec3 from_m, std::uint32_t guess = 0, float slack = 0) const;

  private:
    struct Box {
        glm::vec3 low, high;
        std::uint32_t first, count;  // of order_; no count: two boxes, this one's neighbour and at first
    };
    Nearest on(std::uint32_t triangle, glm::vec3 from_m) const;  // its distance squared
    void split(std::size_t box, std::span<const glm::vec3> middles);
    Box bounded(std::uint32_t first, std::uint32_t count) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Box> boxes_;
};

struct Deviation {
    double rms_m = 0;
    double most_m = 0;
};
// Of the exact mesh from the coarse one, both ways: from each one's vertices and triangles' middles to the other.
Deviation deviation_of(const Mesh& coarse, const Mesh& exact);

float diagonal_m(const Mesh& mesh);  // of its bounding box

}  // namespace quadrat::mesh
