// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/settlement.hpp"
#include "scene/sky.hpp"

namespace quadrat::scene {

// The share of a settlement's windows that are lit under a sky, 0 to 1: none by day, its own by night, more the lower
// the sun stands.
float lit_windows(const Settlement& settlement, const Sky& sky);

// Whether that share lights a window whose lamp has this hour (Masses::lamps), in a house with this evening.
bool is_lit(float lamp, float evening, float lit_share);

}  // namespace quadrat::scene
