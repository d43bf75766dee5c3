// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "base/seed.hpp"
#include "scene/settlement.hpp"
#include "synthesis/houses/facade.hpp"

namespace quadrat::synthesis::houses {

// Mansard: hipped, Gambrel: gabled, each steep below and flat above.
enum class RoofForm : std::uint8_t { Gabled, Hipped, HalfHipped, Mansard, Gambrel };

struct Covering {
    scene::Cladding cladding = scene::Cladding::Plain;
    glm::vec3 colour{0.5F};  // linear
};

// The walls from above, counter-clockwise, x east, y north, metres.
struct Footprint {
    std::vector<glm::dvec2> plan;  // its first side is the front and looks south
    std::vector<bool> is_gable;    // of each of its sides: a gable, where the roof's form has some
};

// A shed that leans against a side, under a roof of its own that falls away from it. Metres.
struct LeanTo {
    std::size_t side = 0;  // of the plan
    double from_m = 0;     // along that
    double width_m = 3, depth_m = 2;
    double high_m = 2.8, low_m = 2.1;  // its roof's edges over the plinth
};

// What a building is to be like. Metres.
struct Design {
    const FacadeGrammar* facade = nullptr;
    Footprint footprint;
    double wall_m = 3;  // from the plinth to the eaves
    double plinth_m = 0.35;
    double pitch_deg = 38;        // of mansard and gambrel roofs below the break
    double upper_pitch_deg = 24;  // and above it
    double break_m = 2.2;         // how high over the eaves that is
    double eave_m = 0.5;          // how far the roof stands out over the walls,
    double verge_m = 0.3;         // and over gables
    RoofForm form = RoofForm::Gabled;
    Covering roof;
    Covering plinth{scene::Cladding::Rubble, {0.3F, 0.28F, 0.26F}};
    glm::vec3 wood{0.10F, 0.07F, 0.05F};               // of barge boards and soffits, linear
    scene::Cladding wall = scene::Cladding::Plaster;   // of the façade's first panel; the others' see kCovers
    scene::Cladding lower = scene::Cladding::Plaster;  // of what the grammar calls Stone
    float wall_warmth = 0;                             // -1 cooler to 1 warmer than the grammar's colours
    float wall_lightness = 1;                          // factor of theirs
    int chimneys = 1;
    int dormers = 0;  // along the front, where its roof slopes to it
    std::vector<LeanTo> lean_tos;
    double tower_m = 0;    // of a chapel's, over its front; 0: none
    float wear = 0;        // 0 as new to 1: stained walls, moss on the roof, shutters that are gone
    float overgrown = 0;   // by climbers, how far: 0 to 1
    float redness = 0.2F;  // chance that they are red
};

inline constexpr double kTowerHalf_m = 1.7;

bool is_gable(const Design& design, std::size_t side);
// Half of the rectangle about the origin that holds all of it, east and south.
glm::vec2 half_of(const Design& design);

// Walls with the façade's panels, a roof over them by the straight skeleton of the plan, chimneys; at three levels.
scene::Building build(const Design& design, base::Seed seed);

// A rectangle; its gables to the front and the back, or to both sides.
Footprint rectangle(double width_m, double depth_m, bool is_gable_front = false);

// A wing at the back: at the east end (L), or in the middle (T); or at the front's east end. It ends in a gable.
enum class Wing : std::uint8_t { BackCorner, BackMiddle, Front };
Footprint with_wing(const Footprint& rectangle, Wing wing, double width_m, double depth_m);

// East and west changed.
Footprint mirrored(const Footprint& footprint);

}  // namespace quadrat::synthesis::houses
