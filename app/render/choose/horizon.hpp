// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::render::choose {

// What ground certainly hides, seen from an eye: by azimuth, the tangent of elevation below which nothing that is
// farther can be seen. The ground is a height field, the eye above it.
class Horizon {
  public:
    static constexpr int kBins = 256;  // once around: fifty or so in a view
    // One serves so far: as much that is hidden stays so, and what a turn brings into view is only not left out.
    static constexpr float kMoved_m = 2.0F;
    static constexpr float kTurned_rad = 0.2F;

    // Of no ground yet: it hides nothing.
    Horizon() { begin({0, 0, 0}, 0); }
    // Again of no ground. What is said of this eye holds for any that is no farther than that from it. sunk: what is
    // drawn of the ground may lie so much lower than it does, for each metre from the eye.
    void begin(glm::vec3 eye_m, float moved_m, float sunk = 0);

    // Of ground that is nowhere lower than low_m within this square. Squares of one grid in the order of their
    // distance on the map.
    void cover(glm::vec3 low_m, glm::vec3 high_m);
    // The box is hidden by ground that was covered; it is farther than all of that on whatever way leads to both.
    bool hides_box(glm::vec3 low_m, glm::vec3 high_m) const;
    // What stands within this radius is hidden by such ground as is nearer, in whatever order it was covered.
    bool hides_standing(glm::vec2 foot_m, float radius_m, float top_m) const;

    // From the eye, on the map.
    static float nearest_m(glm::vec2 eye_m, glm::vec3 low_m, glm::vec3 high_m);

  private:
    using Bins = std::array<float, kBins>;  // tangents
    struct Plan;
    Plan around(glm::vec3 low_m, glm::vec3 high_m, float wider_m) const;
    void keep_ring(float near_m);
    const Bins* bins_within(float reach_m) const;

    glm::vec3 eye_m_{0};
    float moved_m_ = 0;
    float sunk_ = 0;
    float reach_m_ = 0;  // none of its ground is farther
    float next_ring_m_ = 0;
    Bins bins_{};
    // As it was when its ground came no farther than that.
    std::vector<float> ring_reaches_m_;
    std::vector<Bins> rings_;
};

}  // namespace quadrat::render::choose
