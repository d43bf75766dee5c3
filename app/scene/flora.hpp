// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "mesh/image.hpp"
#include "mesh/mesh.hpp"
#include "scene/sward.hpp"

namespace quadrat::scene {

// Trunk and limbs of one species at one level of detail. Roots at the origin, y up. Closed; texture coordinates in
// metres, across and along the limb. Levels change without a step: each vertex knows where it goes before the next
// coarser level takes its place.
struct Wood {
    mesh::Mesh mesh;
    std::vector<glm::vec4>
        grains;                // a vertex: xyz the limb's direction, unit; w the side of it: coordinates run with w
    std::vector<float> ages;   // a vertex: when it appears as the tree grows, 0 seed to 1 grown
    std::vector<float> sways;  // a vertex: 0 rigid to 1 the freest twig
    std::vector<glm::vec3> coarser_m;  // a vertex: on the next level's surface; empty in the coarsest
    std::vector<float> coarser_sways;  // there
    float left_out_m = 0;              // the diameter of the thickest limb that this level leaves out; 0: of the finest
};

// Leaves are opaque folded blades, in shuffled order: any prefix, its blades enlarged by 1/sqrt(share), is a good
// coarser crown. Each blade is a whole number of triangles, all the same; so are the fewer triangles of its plain form.
struct Leaves {
    struct Vertex {
        glm::vec3 site_m;    // where the blade is attached
        glm::vec3 corner_m;  // from the site to this vertex; the shader scales it
        glm::vec3 normal;    // bent toward the crown's outside, so that crowns shade as masses
        glm::vec3 colour;    // linear
        float age = 1;
        float sway = 1;
        float shade = 1;        // light that reaches it through its own crown, 0 to 1
        glm::vec2 on_blade{0};  // across: 0 on the midrib to 1 at the rim; along: 0 the foot to 1 the tip
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> plain_indices;  // over the same vertices, for blades of few pixels; may be empty
    std::size_t blades = 0;
    bool are_sprays = false;  // on twigs of their own: near by each may be drawn again about its foot, all smaller

    std::size_t indices_per_blade() const { return blades == 0 ? 0 : indices.size() / blades; }
    std::size_t indices_per_plain_blade() const { return blades == 0 ? 0 : plain_indices.size() / blades; }
};

// Of all the blades together, one side.
float area_m2(const Leaves& leaves);

// A crown as one mass, for when it is too far away for its leaves: a closed mesh about where they are dense, so that
// the sky still shows through what is thin, and sprays that stand off it. Its vertices are coloured and shaded as the
// leaves about them are.
struct CrownMass {
    mesh::Mesh mesh;                 // without texture coordinates
    std::size_t sprays = 0;          // the last so many of its triangles; each has three vertices of its own, the last
    std::vector<glm::vec3> colours;  // a vertex, linear
    std::vector<float> shades;       // as of leaves
    std::vector<float> ages;
    std::vector<float> sways;
    std::vector<glm::vec3> coarser_m;  // where each vertex is on the next coarser level; empty: there is none
    float share = 1;                   // of the crown's leaves, by area, that it stands for: those within it
};

// Bark pictures: channels 0 and 1 the slope of its relief across and along the limb, 128 level; channel 2 its
// lightness, 128 the bark's own colour; channel 3 unused.
// Leaf pictures: one channel, lightness, 128 a blade's own colour and the mean of all, so that a blade too small to
// show its veins keeps that; columns from the midrib to the rim, rows from the foot to the tip.
// Foliage pictures: one channel, tileable, the same of many leaves over one another, for what stands for so many.

// The storey of a stand that a kind of plant belongs to; planting differs by it.
enum class Storey { Tree, Shrub, Herb };

struct Species {
    std::string name;
    Storey storey = Storey::Tree;
    std::vector<Wood> wood;                      // finest first, at least one
    Leaves leaves;                               // may have no blades
    std::vector<CrownMass> masses;               // of them, finest first; none where they nowhere stand so close
    glm::vec3 bark_colour{0.25F, 0.18F, 0.12F};  // linear
    mesh::Image bark;                            // four channels, tileable: see above; may be empty: plain
    mesh::Image leaf;                            // one channel, see above; may be empty: plain
    mesh::Image foliage;                         // the same
    float bark_tile_m = 0.8F;                    // one tile of it, on the limb
    float height_m = 10;
    float crown_radius_m = 3;
    float trunk_radius_m = 0.2F;
    // Where it grows, used by planting.
    float lowest_m = 0.5F;
    float treeline_m = 400;
    float steepest_slope = 0.8F;  // rise over run
    float moisture = 0.4F;        // of the ground where it does best: 0 dry to 1 wet
    float moisture_width = 0.8F;  // how far from that it still grows
    bool is_tender = false;       // bears no frost
    float shore_liking = 0;       // -1 away from beaches to 1 on them, where others may have the rest of the land
    float arid_liking = 0;        // -1 where it is green to 1 on bare dry ground
    float shade_liking = 0;       // -1 in the open to 1 under trees
    float density = 1;            // of its storey, where it does best: 0 to 1
    float share = 1;              // of the plants of its storey, against the other species
    float turn = 1;               // of a whole turn, that its plants differ by: little where the wind shaped them all
    // The same kind as it grew among its like: indices into its flora's species, -1 where it has but one form. The form
    // of a stand's edge is open toward +x.
    int in_stand = -1, at_edge = -1;
    bool is_form = false;  // of another species: nothing is planted as it but where that one stands
};

// What a species takes of memory: its meshes at every level, its leaves and its pictures.
std::size_t bytes_of(const Species& species);

// How the trees of a flora stand together.
struct Stand {
    float grove_m = 95;
    float grove_contrast = 0.5F;
    float clearings = 0.15F;  // of the land
    float young_share = 0.3F;
    float size_spread = 0.25F;
    float self_thinning = 0.5F;
    float herb_patch_m = 11;
    float fires = 0;           // how often it has burnt: 0 never, then patches of several ages, to 1
    float even_clearings = 0;  // how far clearings keep one another off, 0 to 1
    float giants = 0;          // how far single trees outgrow all others, 0 to 1
    float rings = 0;           // of the ground, where mushrooms come up in rings
    friend bool operator==(const Stand&, const Stand&) = default;
};

struct Flora {
    std::vector<Species> species;  // trees first, then undergrowth
    float spacing_m = 9;           // of trees
    Stand stand;
    Cover cover;
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
