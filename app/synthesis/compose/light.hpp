// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "mesh/field.hpp"
#include "scene/scene.hpp"
#include "synthesis/compose/openness.hpp"

namespace quadrat::synthesis {

// Where the land's own shadow lies: for each sample of the land's heights, how high above the sea the shadow reaches
// (below the ground: in the sun) and how far away what casts it stands.
class LandShadow {
  public:
    // softness: width of the shadows' edges, to the usual.
    LandShadow(const scene::Land& land, const glm::vec3& sun_direction, float softness = 1);

    // The share of the sun's disc seen from this height over that place, soft with the distance of what hides it.
    float sun_at(const glm::vec3& point_m) const;

  private:
    mesh::Field top_m_;
    mesh::Field away_m_;
    float cell_m_;
    float softness_;
};

// Light on the ground: sun past land and crowns, sky past the land, and what the ground around throws back into
// hollows (one bounce). openness: openness_of(land).
scene::BakedLight bake_light(const scene::Land& land, const Openness& openness, const scene::Sky& sky,
                             const scene::Flora& flora, std::span<const scene::Plant> plants, const LandShadow& shadow,
                             int side_px);

// Sets each plant's sun: trees see it at their crown's height past land and neighbours, what is lower takes the
// ground's.
void light_plants(std::span<scene::Plant> plants, const scene::Flora& flora, const scene::Sky& sky,
                  const LandShadow& shadow);

}  // namespace quadrat::synthesis
