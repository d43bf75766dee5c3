// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/land.hpp"
#include "scene/settlement.hpp"

// What stands so near to an eye that it covers what the eye came for.
namespace quadrat::synthesis {

// The corners of arches, outcrops and boulders that stand out of the ground, from west to east.
class StandingRock {
  public:
    explicit StandingRock(const scene::Land& land);

    std::span<const glm::vec3> between(float west_m, float east_m) const;

  private:
    std::vector<glm::vec3> corners_m_;
};

// How high rock about an eye rises in its picture, by bearing.
class NearRock {
  public:
    NearRock(const StandingRock& rock, const glm::vec3& eye_m);
    bool stands_before(const glm::vec3& ray, float land_m) const;

  private:
    static constexpr std::size_t kSides = 72;  // five degrees each: as far apart as rays are
    struct Side {
        float rise = -1.0e6F;  // of the highest point, over its distance
        float nearest_m = 1.0e6F;
    };
    static std::size_t side_of(const glm::vec2& to);
    std::array<Side, kSides> sides_;
};

// The houses about an eye as boxes, to ask of many rays.
class NearHouses {
  public:
    NearHouses(const scene::Settlement& settlement, const glm::vec3& eye_m);
    bool stand_before(const glm::vec3& ray, float land_m) const;

  private:
    struct Box {
        scene::HouseFrame frame;
        glm::vec3 eye_m;   // where it stands in the house's own directions, from its foot
        glm::vec3 size_m;  // half its width, its height, half its depth
    };
    std::vector<Box> boxes_;
};

}  // namespace quadrat::synthesis
