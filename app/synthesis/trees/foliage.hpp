// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "mesh/nearness.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/leaf_shape.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// How a crown is coloured. Colours linear.
struct LeafColours {
    glm::vec3 leaf{0.1F, 0.2F, 0.05F};    // of the crown's light side
    glm::vec3 second{0.2F, 0.2F, 0.05F};  // some blades lean toward it,
    float variety = 0.35F;                // so many and so far: 0 to 1
    glm::vec3 turned{0.5F, 0.2F, 0.03F};  // autumn
    float autumn = 0;                     // of the leaves; those outside turn first
    glm::vec3 blossom{0.9F, 0.8F, 0.8F};
    glm::vec3 fruit{0.6F, 0.05F, 0.03F};
};

struct FoliageOptions {
    LeafKind kind = LeafKind::Ovate;
    std::size_t blades = 1200;
    float length_m = 0.5F;
    float width = 1;          // of a blade to what is usual for its kind
    float inhibition = 0;     // between leaves on a twig: synthesis/trees/inhibition.hpp; 0: flat pairs
    float fold = 0.35F;       // depth of the midrib's fold to half the width
    float scatter_m = 0.3F;   // about a site
    float clumping = 0.4F;    // blades gather about fewer sites
    float droop = 0.15F;      // blades hang: 0 not at all to 1 straight down
    float spread = 1;         // 0: along their twig, 1: every way
    float outward = 0.5F;     // blades point away from the crown's middle
    bool is_rosette = false;  // blades stand around the stem's top as a palm's
    float flower_m = 0.2F;    // across a blossom, a fruit
    float fruit_m = 0.14F;
    LeafColours colours;
    // What is drawn of the limbs, if that is not all of them: it has triangles; borrowed for the call. No blade stands
    // farther from it than reach_m, and a spray's twig begins on it.
    const mesh::Nearness* wood = nullptr;
    float reach_m = 1;
};

// Folded blades about the sites, shuffled; normals bent outward from the crown's middle; light through the crown
// counted in a coarse grid of blades. Sites of flowers and fruits bear the same blades rounded to discs.
scene::Leaves make_foliage(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed);

// The shape of all its blades.
LeafShape shape_of(const FoliageOptions& options);

// Which sites flower or fruit: these shares of them, by chance.
void set_organs(TreeSkeleton& skeleton, float blossom, float fruit, base::Seed seed);

// One blade of a kind along an axis; its upper side toward face.
struct BladeShape {
    glm::vec3 site_m{0};
    glm::vec3 along{0, 1, 0};  // unit
    glm::vec3 face{0, 0, 1};   // unit, across along
    float length_m = 0.3F;
    float half_width_m = 0.08F;
    float fold_m = 0.03F;
    float bow_m = 0;          // the tip bends toward face by so much
    bool is_disc = false;     // a flower or a fruit: round, about its site
    bool is_cluster = false;  // of flowers, where the shape has leaves enough
    glm::vec3 twig_m{0};      // from the site to where the twig begins that bears a spray
};
void add_blade(scene::Leaves& leaves, const LeafShape& shape, const BladeShape& blade,
               const scene::Leaves::Vertex& common);

}  // namespace quadrat::synthesis::trees
