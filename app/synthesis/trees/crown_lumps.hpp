// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

namespace quadrat::synthesis::trees {

// What makes a crown from afar a heap of boughs instead of a ball: bulges and hollows of its surface, by the place
// alone, so that all its levels have the same.
class CrownLumps {
  public:
    // The box about a crown, m.
    CrownLumps(const glm::vec3& low_m, const glm::vec3& high_m);

    // At a place: -1 deep in a hollow to 1 on top of a bulge, smooth, 0 in the mean.
    float at(const glm::vec3& at_m) const;
    // How far the surface there is moved outward.
    float outward_m(const glm::vec3& at_m) const;
    // The normal of the surface that was moved so. Both are of unit length.
    glm::vec3 normal(const glm::vec3& at_m, const glm::vec3& smooth) const;
    // Of the light on the smooth crown, what reaches it: hollows are darker.
    float light(const glm::vec3& at_m) const;

  private:
    float swing_m(const glm::vec3& at_m) const;

    glm::vec3 middle_m_;
    float radius_m_;
    float cell_m_;
};

}  // namespace quadrat::synthesis::trees
