// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "mesh/plan_check.hpp"
#include "mesh/straight_skeleton.hpp"
#include "mesh/wavefront.hpp"

namespace quadrat::mesh {

struct PlaneOwner {
    int point = 0;  // where its edge starts
    int course = 0;
};

struct FinishedFront {
    const CheckedPlan& plan;
    const Wavefront& front;
    const std::vector<PlaneOwner>& owners;  // of each plane
    double metres_per_scaled = 1;
};

// The faces between the lines that the wavefront left behind.
Roof roof_from(const FinishedFront& finished);

}  // namespace quadrat::mesh
