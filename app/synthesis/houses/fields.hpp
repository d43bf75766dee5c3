// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "synthesis/houses/settle.hpp"

namespace quadrat::synthesis::houses {

// Fields about a settlement: cells of a Voronoi diagram, split into lots; on ground that a plough can work, off houses
// and lanes.
std::vector<scene::FieldPlot> lay_fields(const scene::Land& land, const Settled& settled,
                                         const scene::LandParameters& parameters, base::Seed seed);

// The corners of the box about an outline, which is not empty: the least and the most of both.
struct Extent {
    glm::vec2 low_m, high_m;
};
Extent extent_of(const std::vector<glm::vec2>& outline_m);

// A convex outline, either way round, to ask of many places.
class Inside {
  public:
    explicit Inside(const std::vector<glm::vec2>& outline);
    float by_m(glm::vec2 at) const {  // less than 0 outside
        float least = 1.0e9F;
        for (const glm::vec3& side : sides_) least = std::min(least, side.x * at.x + side.y * at.y + side.z);
        return least;
    }

  private:
    std::vector<glm::vec3> sides_;  // x, y inward, z offset
};

}  // namespace quadrat::synthesis::houses
