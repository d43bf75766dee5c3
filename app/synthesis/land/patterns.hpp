// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"

namespace quadrat::synthesis::land {

// See scene::Land::lichen: two kinds of crust that keep to colonies of their own, how much of the rock they cover by
// share, 0 to 1. Tileable.
mesh::Image lichen_picture(base::Seed seed, float share);

// How bare dry ground is between the bands of what grows on it, 0 to 1: tileable, one tile kBandsTile_m wide. Plants
// that draw water from around them stand in bands, spots and gaps (Klausmeier, "Regular and irregular patterns in
// semiarid vegetation", 1999).
mesh::Field bare_bands(base::Seed seed);
inline constexpr float kBandsTile_m = 256;

}  // namespace quadrat::synthesis::land
