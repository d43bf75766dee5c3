// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::synthesis::trees {

// A plant as curves. Every limb begins on its parent, at the parent's node of the same place.
struct Limb {
    struct Node {
        glm::vec3 at_m{0};
        float radius_m = 0;
        float path_m = 0;  // along the limbs, from the root
    };
    std::vector<Node> nodes;  // at least two
    int order = 0;            // 0 the trunk, 1 what it bears …
    int generation = 0;       // of its first internode: the derivation step that made it
    int parent = -1;          // index of a limb before it; -1: rooted in the ground
};

// Where leaves may stand.
struct LeafSite {
    glm::vec3 at_m{0};
    glm::vec3 along{0, 1, 0};  // the twig's direction, unit
    float path_m = 0;
};

struct TreeSkeleton {
    std::vector<Limb> limbs;  // the trunk first
    std::vector<LeafSite> sites;
    float longest_path_m = 0;
    glm::vec3 low_m{0};  // bounds of limbs and sites
    glm::vec3 high_m{0};
};

}  // namespace quadrat::synthesis::trees
