// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace quadrat::mesh {

// Where two vertices meet. Their attributes are always those of a point of the edge between them.
enum class Placement {
    Line,    // at that point, as in the source paper
    Fitted,  // from there to where the planes of both are nearest: a sixth to a quarter less error
             // later
};

// What a progressive mesh is made from, beside the mesh itself. Borrows all of it.
struct ProgressiveOptions {
    std::size_t fewest = 60;  // vertices of the coarsest level, about: from 0.7 to 1.4 times as many
    Placement placement = Placement::Fitted;
    std::span<const float> attributes = {};     // of any meaning, so many a vertex, one vertex after the other
    std::size_t attributes_a_vertex = 0;        // their mean is followed where vertices meet
    std::span<const std::uint8_t> materials{};  // one a triangle; empty: one for all. Where two meet stays an edge
};

// Meshes of one thing, each with half the vertices of the one before.
struct Progressive {
    struct Level {
        Mesh mesh;
        std::vector<float> attributes;        // as in the options
        std::vector<std::uint8_t> materials;  // one a triangle, as in the options
        // A vertex: the vertex of the next level that it has become part of. Empty in the coarsest.
        std::vector<std::uint32_t> parents;
        // How far the surface lies from where it was: the dearest collapse so far, as the root of the mean square of
        // its distances from the planes it replaces. Never less than the level before; 0 in the finest.
        float error_m = 0;
    };
    enum class End {
        Reached,      // as coarse as was asked
        NothingToDo,  // no triangles
        AllAreRigid,  // whatever is left would fold, tear, or lose a piece: tetrahedra, corners of rims and seams
    };
    std::vector<Level> levels;  // finest first: the mesh itself, without vertices that no triangle uses
    End end = End::NothingToDo;
};

// Borders, seams (where vertices at one place differ in normal or texture coordinate) and edges between materials
// stay where they are but for collapses along them; no triangle turns by a right angle. A vertex on such an edge
// between materials is one vertex for each of them in every level. The same result on every machine.
Progressive make_progressive(const Mesh& mesh, const ProgressiveOptions& options = {});

// Where each vertex of a level stands once the next level has wholly taken its place: what a vertex shader mixes its
// position with. The coarsest level: where it stands.
std::vector<glm::vec3> morph_targets_m(const Progressive& progressive, std::size_t level);

// From how far a level of this error is good enough: D = alpha E^beta. An error is a length and so is a distance:
// beta is 1, a thing of ten times the size changes at ten times the distance, and alpha is pixels a radian over the
// pixels that may differ.
float ideal_distance_m(const Progressive::Level& level, float alpha);

// The level for a distance and how far it has become the next one: its whole part and its fraction.
float level_at(const Progressive& progressive, float distance_m, float alpha);

}  // namespace quadrat::mesh
