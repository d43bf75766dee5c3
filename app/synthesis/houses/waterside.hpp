// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "synthesis/houses/settle.hpp"

namespace quadrat::synthesis::houses {

// Jetties where a settlement lies by deep enough water, and boats moored along them; a piece each, where it stands.
std::vector<scene::Masses> add_jetties(const scene::Land& land, const Settled& settled,
                                       const scene::LandParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::houses
