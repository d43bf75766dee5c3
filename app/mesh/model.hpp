// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"

namespace quadrat::mesh {

// Named meshes with a colour, and where each stands: what other tools read. Metres, y up, right-handed.
struct Model {
    struct Part {
        std::string name;  // letters, digits, '-' and '_'
        Mesh mesh;
        glm::vec3 colour{0.5F};  // linear, 0 to 1
    };
    struct Placed {
        std::size_t part = 0;
        glm::vec3 at_m{0};
        float yaw_rad = 0;  // about y, counter-clockwise seen from above
        float scale = 1;
    };
    std::vector<Part> parts;
    std::vector<Placed> placed;  // empty: every part once, where it is
};

// Wavefront OBJ, instances written out. Vertex colours stand after the positions, in sRGB: nothing standardises them,
// and Blender, MeshLab and assimp's viewers take them as they would a picture's.
std::string to_obj(const Model& model);
std::string to_glb(const Model& model);   // binary glTF 2.0, instances as nodes; colours linear, as it demands
std::string to_gltf(const Model& model);  // the same as text, its numbers within it

// By the ending of its name.
inline constexpr std::array<std::string_view, 3> kModelEndings{".obj", ".glb", ".gltf"};
std::string model_file(const Model& model, std::string_view ending);

}  // namespace quadrat::mesh
