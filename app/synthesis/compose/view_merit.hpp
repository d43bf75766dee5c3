// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/camera.hpp"
#include "scene/land.hpp"
#include "synthesis/compose/near_things.hpp"

namespace quadrat::synthesis {

class Picture;

// What a camera of 16 by 9 sees of a land, as shares of its picture.
struct Outlook {
    float sky = 0;
    float water = 0;
    float near = 0;    // ground nearer than 45 m
    float far = 0;     // farther than 500 m
    float walled = 0;  // nearer than 12 m: a slope before the eyes
    float roofed = 0;  // of houses nearer than 32 m: walls and roofs before the eyes
    float stony = 0;   // of rock that stands on the ground nearer than 55 m and that the picture's sides cut off
    float housed = 0;  // of a settlement's houses, the share that the picture holds, large enough and not behind land
    float made = 0;    // of arches and standing stones in sight: the sum of how large they look, in radians
    float marked = 0;  // of the largest landmark in sight that is no cave: how large it looks, in radians
    float cave = 0;    // of the largest mouth of a cave in sight, the same
    float road = 0;    // of roads that are no lanes
};
Outlook outlook(const scene::Land& land, const scene::Camera& camera);

// One land, to look out over from many places: what there is to look for is found once. The land stays as it is.
class Lookout {
  public:
    explicit Lookout(const scene::Land& land);
    Lookout(scene::Land&&) = delete;

    Outlook outlook(const scene::Camera& camera) const;
    const scene::Land& land() const { return *land_; }

  private:
    // Of a road that is no lane, from one of its points to the next.
    struct Stretch {
        glm::vec3 at_m, ground_normal;
        float area_m2;
    };
    bool is_behind_land(const glm::vec3& eye_m, const glm::vec3& at_m, float distance_m) const;
    void look_for_landmarks(const glm::vec3& eye_m, const Picture& picture, Outlook& seen) const;
    float road_in_sight(const scene::Camera& camera, const Picture& picture) const;
    float housed_share(const glm::vec3& eye_m, const Picture& picture) const;

    const scene::Land* land_;
    float ceiling_m_;
    std::vector<scene::Landmark> marks_;  // the land's own first; then tall stones
    std::vector<Stretch> roads_;
    StandingRock rock_;
};

// How well a landscape painter would like it: something near, something far, water if there is any, a third of sky.
float view_merit(const Outlook& seen);

}  // namespace quadrat::synthesis
