// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "synthesis/houses/facade.hpp"

// Windows and doors that are set back in a wall. Not for use from outside.
namespace quadrat::synthesis::houses {

using Outline = std::vector<glm::dvec2>;  // convex, counter-clockwise

struct Opening {
    glm::dvec2 low_m{0}, high_m{0};
    bool is_panel = false;  // a door's: a panel closes it by itself
    std::size_t panel = 0;  // that one, or any pane of the window
};

struct Recess {
    Opening opening;
    std::size_t in = 0;  // the innermost panel that holds it; it is cut out of all that do
};

// Of the openings, those that some panel holds wholly, and that lie in no other one.
std::vector<Recess> recesses_of(const std::vector<FacadePanel>& panels, const std::vector<Opening>& openings);

bool holds(const FacadePanel& panel, const Opening& opening);

// What is left of an outline, in convex pieces that are cut at these heights too.
std::vector<Outline> without(const Outline& outline, const std::vector<Opening>& holes, std::vector<double> cuts_m);

}  // namespace quadrat::synthesis::houses
