// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::synthesis::noise {

// Fungi that spread through the ground, eat what they reach and leave it spent: how dense they are on a torus of side
// by side samples. They end as rings about where each began, and two rings that meet go out where they touch.
struct FairyRings {
    int beginnings = 5;  // by chance, each at its own time, so that rings are of several sizes
    int steps = 45;
};
mesh::Field fairy_rings(const FairyRings& rings, base::Seed seed, int side);

}  // namespace quadrat::synthesis::noise
