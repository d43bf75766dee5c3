// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::synthesis::land {

// One bend of the land, felt as a bell about its place.
struct Deformation {
    enum class Kind {
        Raise,  // by amount; what is finer stays
        Level,  // toward the height amount; what is finer is pressed flat with it
    };
    Kind kind = Kind::Raise;
    float column = 0;  // of its middle, samples
    float row = 0;
    float reach = 1;   // where it has fallen to nothing, samples
    float amount = 0;  // heights
};

struct DeformationSearch {
    float wished_cost = 0.05F;  // root of the mean square that may be left between land and mask, in heights
    int most = 400;             // deformations
    int reach = 16;             // samples: over (2 reach + 1) squared of them land and mask are compared in the mean
};

struct Bent {
    std::vector<Deformation> deformations;
    double cost_before = 0;  // root of the mean square between the land's means and the mask's
    double cost = 0;         // what is left of it
    double moved = 0;        // mean distance that the land was moved up or down
    int tried = 0;           // deformations that were weighed
};

// Bends a random land to a mask of wished heights (of any size) by a search: of deformations tried at chance where the
// land is farthest from the mask, the one that lowers the cost most is made, until the cost is as wished or no other
// lowers it. The search is the same for the same seed. at: told after each how many were made; it may throw.
Bent bend_to_mask(mesh::Field& height, const mesh::Field& mask, const DeformationSearch& search, base::Seed seed,
                  const std::function<void(int)>& at = {});

// What a search has found, made on a field of that size.
void deform(mesh::Field& height, const std::vector<Deformation>& deformations);

}  // namespace quadrat::synthesis::land
