// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/fields.hpp"
#include "synthesis/houses/settle.hpp"

namespace quadrat::synthesis::houses {

// Colours the ground that people use, in a picture of the land's square, sRGB: fields in rows, gardens (green: 0 to 1),
// worn earth about walls and doors and along lanes.
void paint_grounds(mesh::Image& albedo, const scene::Land& land, const Settled& settled,
                   const std::vector<scene::FieldPlot>& fields, float green, base::Seed seed);

}  // namespace quadrat::synthesis::houses
