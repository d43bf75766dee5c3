// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "scene/camera.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

inline constexpr int kRayColumns = 13;

// Rays spread evenly over a picture of 16 by 9: unit directions, so many in each row, from left to right.
std::vector<glm::vec3> view_rays(const scene::Camera& camera);

// That picture, to ask of many points.
class Picture {
  public:
    explicit Picture(const scene::Camera& camera);
    // Where a point stands in it, -1 to 1 rightward and up within it; nowhere if it is less than 4 m before the eye.
    std::optional<glm::vec2> at(const glm::vec3& at_m) const;

  private:
    glm::vec3 eye_m_, ahead_, right_, up_;
    float half_up_;  // of the picture, at a distance of 1
};
std::optional<glm::vec2> in_picture(const scene::Camera& camera, const glm::vec3& at_m);

inline constexpr float kFarthest_m = 5000;
struct Hit {
    float distance_m;  // kFarthest_m: the sky
    bool is_water;
};

// How far is looked: no higher than this where a ray rises, and not so far away.
struct Within {
    float ceiling_m = 900;
    float farthest_m = kFarthest_m;
};
// What a ray from the eye meets first, land or water.
Hit first_hit(const scene::Land& land, const glm::vec3& eye, const glm::vec3& ray, const Within& within = {});
// For many rays over one land: under this ceiling they meet the same as under the usual one.
float ceiling_over_m(const scene::Land& land);

}  // namespace quadrat::synthesis
