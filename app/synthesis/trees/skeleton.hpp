// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::synthesis::trees {

// A plant as curves, as every grower makes it. A limb begins on its parent's node parent_node and at the same place.
struct Limb {
    struct Node {
        glm::vec3 at_m{0};
        float radius_m = 0;
        float path_m = 0;  // along the limbs, from the root
        float sway = 0;    // 0 rigid to 1 the freest twig
    };
    std::vector<Node> nodes;  // at least two
    int order = 0;            // 0 the trunk, 1 what it bears …
    int parent = -1;          // index of a limb before it; -1: rooted in the ground
    int parent_node = 0;
};

enum class Organ : std::uint8_t { Leaf, Flower, Fruit, YoungLeaf, TurnedLeaf, None };

// Where something may stand: a frame on a twig.
struct Site {
    glm::vec3 at_m{0};
    glm::vec3 along{0, 1, 0};  // the twig's direction, unit
    glm::vec3 out{1, 0, 0};    // the side it stands on, unit, across along
    float path_m = 0;
    int limb = 0;
    int node = 0;      // the limb's last node before it
    float weight = 1;  // how many leaves stand here, against the other sites
    Organ organ = Organ::Leaf;
};

struct TreeSkeleton {
    std::vector<Limb> limbs;  // parents before what they bear
    std::vector<Site> sites;
    float longest_path_m = 0;
    glm::vec3 low_m{0};  // bounds of limbs and sites
    glm::vec3 high_m{0};
};

// Bounds, paths and sways anew, after nodes have moved. A twig's sway grows along the limbs with their slenderness.
void measure(TreeSkeleton& skeleton);

// One plant more, where it stands. Bounds, paths and sways are left as they were.
void append(TreeSkeleton& to, TreeSkeleton from);

// Everything larger by a factor each way, radii by radius_factor.
void stretch(TreeSkeleton& skeleton, const glm::vec3& factors, float radius_factor);

// Leonardo's rule, the pipe model (Shinozaki 1964): a limb's radius to this power is the sum of those it bears.
struct PipeModel {
    float exponent = 2.3F;
    float trunk_radius_m = 0.3F;  // at the root; tips follow
    float least_radius_m = 0.008F;
};
void set_pipe_radii(TreeSkeleton& skeleton, const PipeModel& model);

// What bends limbs after they have grown, in the order of their strength. Lengths and radii stay.
struct Forces {
    float sag = 0;            // 0 to 1: how far limbs hang under what they bear
    float straightening = 0;  // 0 to 1: how far the young ends of those that sagged have turned up again
    glm::vec3 wind{0};        // direction times 0 to 1
    glm::vec3 light{0};       // the same
};
void bend(TreeSkeleton& skeleton, const Forces& forces);

// The strongest limbs that are no more than most in number of nodes, in their order; what they bear is left out with
// them. None: only the trunk.
std::vector<std::uint32_t> strongest_limbs(const TreeSkeleton& skeleton, std::size_t most_nodes);

}  // namespace quadrat::synthesis::trees
