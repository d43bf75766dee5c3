// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"

namespace quadrat::synthesis::trees {

// Ribbed: of a cactus; no gene chooses it.
enum class Bark { Furrowed, Plates, Smooth, Banded, Ribbed };

// Tileable relief of bark, 0 to 1, side x side samples: columns around the limb, rows along it.
mesh::Field bark_relief(Bark kind, base::Seed seed, int side);

// The picture that scene::Species wants of it: slopes and lightness, deeper by depth 0 to 1.
mesh::Image bark_picture(const mesh::Field& relief, float depth);

}  // namespace quadrat::synthesis::trees
