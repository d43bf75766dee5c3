// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/fields.hpp"

namespace quadrat::synthesis::houses {

// Hedges, dry walls and fences around the gardens of some houses and along some fields, as the region has them: a piece
// a plot, where it stands. They leave lanes, doors and neighbours free.
std::vector<scene::Masses> add_bounds(const scene::Land& land, const Settled& settled,
                                      const std::vector<scene::FieldPlot>& fields,
                                      const scene::LandParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::houses
