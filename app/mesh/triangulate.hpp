// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::mesh {

// Triangles, three numbers each, counter-clockwise, that cover a simple polygon: numbers into points, the outline
// counter-clockwise, holes clockwise. An outline that is monotone in x and has no holes takes linear time. Corners
// without area are left out. Fewer than three points: none.
std::vector<std::uint32_t> triangulate(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& outline,
                                       const std::vector<std::vector<std::uint32_t>>& holes = {});

// Does the outline go once to the right and once back?
bool is_monotone(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& outline);

}  // namespace quadrat::mesh
