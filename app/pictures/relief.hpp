// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/field.hpp"
#include "mesh/image.hpp"

namespace quadrat::pictures {

// A heightfield as a block seen aslant from the south, lit from the north-west and coloured by height: to compare
// fields by eye. Heights are taken as fractions of half the field's side, times exaggeration. side_px by about side_px.
mesh::Image draw_relief(const mesh::Field& height, int side_px, float exaggeration);

}  // namespace quadrat::pictures
