// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "mesh/straight_skeleton.hpp"

namespace quadrat::mesh {

// A plan that is known to be one: whole-number points, the outer loop counter-clockwise, holes clockwise, so that the
// inside is to the left of every edge.
struct CheckedPlan {
    struct Point {
        std::int64_t x = 0, y = 0;  // in units of 1 / units_per_m from the centre; at most 2^50
    };
    std::vector<Point> points;            // edge i starts at point i
    std::vector<std::vector<int>> loops;  // the points of each, in order
    std::vector<int> next;                // of each point
    std::vector<int> edge;                // its number in the plan
    std::vector<glm::dvec2> given;        // each point as it was given
    glm::dvec2 centre_m{0};
    double units_per_m = 1;  // a power of ten, so that decimal fractions keep their places
    double near_units = 0;   // nearer to each other than this nothing lies

    glm::dvec2 metres(std::size_t i) const { return given[i]; }
};

// Throws PlanError as straight_skeleton does.
CheckedPlan checked(const Plan& plan);

}  // namespace quadrat::mesh
