// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace quadrat::mesh {

// What two shapes have in common: outlines counter-clockwise, holes clockwise, in any order; each shape's loops are
// simple and do not cross. Shapes may come apart and need not be convex. Nothing where a point of one lies on an edge
// of the other, or so near that it cannot be told on which side; then move one of them a little.
std::optional<std::vector<std::vector<glm::dvec2>>> common_area(const std::vector<std::vector<glm::dvec2>>& a,
                                                                const std::vector<std::vector<glm::dvec2>>& b);

// Outlines with the holes that lie in them, one after the other: each shape on its own, its outline first.
std::vector<std::vector<std::vector<glm::dvec2>>> sorted_into_shapes(const std::vector<std::vector<glm::dvec2>>& loops);

// Whether a point lies in a shape of loops, by how often they wind round it.
bool is_inside(const std::vector<std::vector<glm::dvec2>>& loops, glm::dvec2 at);

double signed_area(const std::vector<glm::dvec2>& loop);  // above 0 counter-clockwise

}  // namespace quadrat::mesh
