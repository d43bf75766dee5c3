// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/stone.hpp"

// What boulders, arches and caves are made with.
namespace quadrat::synthesis::land {

inline constexpr glm::vec2 kViewer_m{0, 300};  // where the camera's way lies, about

float slope_at(const scene::Land& land, glm::vec2 at_m);  // rise over run

// Rock in beds, as the ground paints it.
class Strata {
  public:
    Strata(const Palette& palette, const scene::LandParameters& p)
        : light_(palette.rock_light), dark_(palette.rock_dark), bed_m_(p.ground_strata_m), contrast_(p.ground_strata) {}

    glm::vec3 at(float height_m, float wander) const;

  private:
    glm::vec3 light_, dark_;
    float bed_m_;
    float contrast_;
};

// A triangle with corners of its own, so that it is flat; none where it has no area.
void add_facet(scene::Stone& stone, const std::array<glm::vec3, 3>& corners, const std::array<glm::vec3, 3>& colours);

// Of the stone from this vertex on: normals bent so far, 0 to 1, to the mean of the facets that meet there. Weather
// takes edges off; none taken off is crystal.
void round_off(scene::Stone& stone, std::size_t from, float share);

void add_boulder(Stones& stones, const Strata& strata, const glm::vec3& foot_m, float radius_m,
                 base::RandomStream& random);

// A ring of hewn stones on the ground that is kept for a settlement, some with a lintel; none without such ground.
void add_standing_stones(Stones& stones, const scene::Land& land, const Strata& strata, base::Seed seed);

// Whether the ground between lets the viewer see a point.
bool is_in_sight(const scene::Land& land, const glm::vec3& point);

// Up to two, in slopes that the viewer sees, where arch_share asks for such stone.
void add_caves(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
               base::Seed seed);

// Below this arch_height_m a fin stands where arches would.
inline constexpr float kTallestFin_m = 14;

// A fin of bedded rock, weathered so that one can stand under it (overhangs.hpp); none where no ground is level enough.
void add_fin(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
             base::Seed seed);

// Dry walls between fields, where wall_share asks for them; none where there is too little ground for them.
void add_field_walls(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, base::Seed seed);

// Rock in steps, where ledge_share asks for it; none where no ground is level enough.
void add_rock_ledges(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                     base::Seed seed);

// Climbers up the rock that stands by itself, by climber_share; none above the snow.
void add_rock_climbers(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, base::Seed seed);

// Arches by arch_share.
void add_arches(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                base::Seed seed);

}  // namespace quadrat::synthesis::land
