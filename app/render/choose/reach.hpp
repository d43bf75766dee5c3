// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace quadrat::render::choose {

// Which part of a landscape is drawn: all of it, or what lies on one side of an upright cylinder about a place on the
// map. Along a line of sight from that place what is near lies before what is far, always. What is cut (ground, water,
// cover, stone) belongs to both sides where it may cross; what stands (a plant) belongs to one, whole.
struct Reach {
    enum class Part : std::uint8_t { Whole, Near, Far };
    Part part = Part::Whole;
    glm::vec2 about_m{0};  // east and south
    float split_m = 0;     // radius

    // What is cut is drawn so far beyond the split on either side, at least as far as an eye moves from the place.
    static constexpr float kOverlap_m = 2;
    // Of plants that lean over the split, how far at most: so far there is near ground, for them to stand on.
    static constexpr float kUnderCrowns_m = 10;

    // What of a plant is nearest decides: none that is far reaches over near ground.
    bool holds_standing(glm::vec2 foot_m, float radius_m) const {
        if (part == Part::Whole) return true;
        const bool is_near = glm::distance(foot_m, about_m) - std::min(radius_m, kUnderCrowns_m) < split_m;
        return is_near == (part == Part::Near);
    }
    // Something that lies between these distances from the place.
    bool may_hold(float nearest_m, float farthest_m, float overlap_m = kOverlap_m) const {
        if (part == Part::Whole) return true;
        return part == Part::Near ? nearest_m < split_m + overlap_m : farthest_m > split_m - kOverlap_m;
    }
    bool may_hold_box(const glm::vec3& low_m, const glm::vec3& high_m, float overlap_m = kOverlap_m) const {
        if (part == Part::Whole) return true;
        const glm::vec2 low{low_m.x - about_m.x, low_m.z - about_m.y};
        const glm::vec2 high{high_m.x - about_m.x, high_m.z - about_m.y};
        return may_hold(glm::length(glm::clamp(glm::vec2{0}, low, high)),
                        glm::length(glm::max(glm::abs(low), glm::abs(high))), overlap_m);
    }
    bool may_hold_ground(const glm::vec3& low_m, const glm::vec3& high_m) const {
        return may_hold_box(low_m, high_m, kUnderCrowns_m);
    }
    bool may_hold_sphere(const glm::vec3& middle_m, float radius_m) const {
        const float away_m = glm::distance(glm::vec2{middle_m.x, middle_m.z}, about_m);
        return may_hold(away_m - radius_m, away_m + radius_m);
    }
    friend bool operator==(const Reach&, const Reach&) = default;
};

}  // namespace quadrat::render::choose
