// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace quadrat::scene {

// Trunk and limbs of one species at one level of detail. Roots at the origin, y up.
struct Wood {
    mesh::Mesh mesh;
    std::vector<float> ages;   // a vertex: when it appears as the tree grows, 0 seed to 1 grown
    std::vector<float> sways;  // a vertex: 0 rigid to 1 the freest twig
};

// Leaves are opaque folded blades, in shuffled order: any prefix, its blades enlarged by 1/sqrt(share), is a good
// coarser crown. Each blade is a whole number of triangles, all the same.
struct Leaves {
    struct Vertex {
        glm::vec3 site_m;    // where the blade is attached
        glm::vec3 corner_m;  // from the site to this vertex; the shader scales it
        glm::vec3 normal;    // bent toward the crown's outside, so that crowns shade as masses
        glm::vec3 colour;    // linear
        float age = 1;
        float sway = 1;
        float shade = 1;  // light that reaches it through its own crown, 0 to 1
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::size_t blades = 0;

    std::size_t indices_per_blade() const { return blades == 0 ? 0 : indices.size() / blades; }
};

// The storey of a stand that a kind of plant belongs to; planting differs by it.
enum class Storey { Tree, Shrub, Herb };

struct Species {
    std::string name;
    Storey storey = Storey::Tree;
    std::vector<Wood> wood;                      // finest first, at least one
    Leaves leaves;                               // may have no blades
    glm::vec3 bark_colour{0.25F, 0.18F, 0.12F};  // linear
    float height_m = 10;
    float crown_radius_m = 3;
    float trunk_radius_m = 0.2F;
    // Where it grows: a preference for height and slope, used by planting.
    float lowest_m = 0.5F;
    float treeline_m = 400;
    float steepest_slope = 0.8F;  // rise over run
    float share = 1;              // of the plants, against the other species
};

struct Flora {
    std::vector<Species> species;  // trees first, then undergrowth
    float spacing_m = 9;           // of trees
};

// One plant standing in the scene.
struct Plant {
    std::uint32_t species = 0;
    glm::vec3 root_m{0};
    float yaw_rad = 0;
    float scale = 1;  // of the species' size
    float sun = 1;    // sun that reaches it past land and neighbours, 0 to 1
    float tint = 0;   // -1 to 1: lighter or darker, yellower or bluer than its kind
    float delay = 0;  // 0 to 1: when in a new generation's arrival it begins to grow
};

}  // namespace quadrat::scene
