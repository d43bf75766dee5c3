// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "scene/flora.hpp"
#include "synthesis/trees/skeleton.hpp"

// Three ways from limbs to a mesh. Each makes closed 2-manifolds, counter-clockwise seen from outside, with ages, sways
// and bark coordinates: u runs in metres around the limb from its mark to its back and on the other side back again, v
// in metres along the limbs from the root; so there is no seam where a turn is full.
namespace quadrat::synthesis::trees {

struct TubeDetail {
    int trunk_sides = 8;                                    // thinner limbs have fewer, 3 at least
    std::size_t most_nodes = static_cast<std::size_t>(-1);  // of the strongest limbs; all of the trunk
    float flattest = 0;    // nodes are left out where the limb bends by less than this share of its radius
    bool has_foot = true;  // the trunk spreads at its foot
};

// Which ring of the mesh belongs to which limb: levels of detail leave out limbs, not triangles.
struct TubeRing {
    std::uint32_t limb;
    std::uint32_t node;
    std::uint32_t first_vertex;
    std::uint32_t sides;
};

// One tube a limb, swept along it, closed by a point at both ends.
scene::Wood sweep_tubes(const TreeSkeleton& skeleton, const TubeDetail& detail, std::vector<TubeRing>* rings = nullptr);

// "Genetic selection of parametric scenes", 2003, section 5.1.2: a tapered cylinder an internode, its ends conical.
scene::Wood mesh_cylinders(const TreeSkeleton& skeleton, int sides);

// The same paper's meta-tubes: a field about each limb, their sum polygonised where it crosses one half. Joins are
// smooth.
struct MetaTubeDetail {
    float cell_m = 0.1F;
    bool sweeps_twigs = true;  // limbs too thin for the cells become swept tubes; otherwise they are thickened to them
    int twig_sides = 4;
    std::size_t most_nodes = static_cast<std::size_t>(-1);
    bool has_foot = true;
};
scene::Wood mesh_meta_tubes(const TreeSkeleton& skeleton, const MetaTubeDetail& detail);

// The cell at which meta-tubes give about so many triangles.
float cell_for(const TreeSkeleton& skeleton, std::size_t triangles);

// Room for so many vertices in each of the wood's attributes.
void resize_vertices(scene::Wood& wood, std::size_t count);

// The trunk's nodes with a foot that widens into the ground.
std::vector<Limb::Node> with_foot(const Limb& trunk);

// When in a tree's arrival wood of this path appears, 0 to 1.
float age_at(const TreeSkeleton& skeleton, float path_m);

}  // namespace quadrat::synthesis::trees
