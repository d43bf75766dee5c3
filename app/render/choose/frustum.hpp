// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace quadrat::render::choose {

// The six planes of what a camera sees (Gribb & Hartmann 2001), unit normals inward.
class Frustum {
  public:
    explicit Frustum(const glm::mat4& clip_from_world);

    // False only when it is certainly out of sight.
    bool may_see_sphere(glm::vec3 middle_m, float radius_m) const;
    // What lies from the apex along these ways and between them, however far.
    bool may_see_cone(glm::vec3 apex_m, std::span<const glm::vec3> ways) const;
    bool may_see_box(glm::vec3 low_m, glm::vec3 high_m) const;
    bool sees_whole_box(glm::vec3 low_m, glm::vec3 high_m) const;

    const std::array<glm::vec4, 6>& planes() const { return planes_; }

  private:
    std::array<glm::vec4, 6> planes_;
};

}  // namespace quadrat::render::choose
