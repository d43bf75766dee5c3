// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "base/seed.hpp"
#include "scene/settlement.hpp"
#include "synthesis/houses/facade.hpp"

namespace quadrat::synthesis::houses {

enum class RoofForm : std::uint8_t { Gabled, Hipped, HalfHipped };

struct Covering {
    scene::Cladding cladding = scene::Cladding::Plain;
    glm::vec3 colour{0.5F};  // linear
};

// What a building is to be like. Metres.
struct Design {
    const FacadeGrammar* facade = nullptr;
    std::vector<glm::dvec2> plan;  // the walls from above, counter-clockwise, x east, y north; the front looks south
    std::vector<bool> is_gable;    // of each of its sides: a gable, where the roof's form has some
    double wall_m = 3;             // from the plinth to the eaves
    double plinth_m = 0.35;
    double pitch_deg = 38;
    double eave_m = 0.5;   // how far the roof stands out over the walls,
    double verge_m = 0.3;  // and over gables
    RoofForm form = RoofForm::Gabled;
    Covering roof;
    Covering plinth{scene::Cladding::Rubble, {0.3F, 0.28F, 0.26F}};
    glm::vec3 wood{0.10F, 0.07F, 0.05F};               // of barge boards and soffits, linear
    scene::Cladding wall = scene::Cladding::Plaster;   // of the façade's first panel; the others' see kCovers
    scene::Cladding lower = scene::Cladding::Plaster;  // of what the grammar calls Stone
    float wall_warmth = 0;                             // -1 cooler to 1 warmer than the grammar's colours
    float wall_lightness = 1;                          // factor of theirs
    int chimneys = 1;
    double tower_m = 0;  // of a chapel's, over its front; 0: none
};

// Walls with the façade's panels, a roof over them by the straight skeleton of the plan, chimneys; at three levels.
scene::Building build(const Design& design, base::Seed seed);

// A rectangle, its longer side the front where is_broad; with a wing toward the north where wing_m is above 0.
std::vector<glm::dvec2> plan_of(double width_m, double depth_m, double wing_width_m = 0, double wing_m = 0);

}  // namespace quadrat::synthesis::houses
