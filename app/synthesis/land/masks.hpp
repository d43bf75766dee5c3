// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/field.hpp"

namespace quadrat::synthesis::land {

// A field of another size brought to this one, bilinear; corners meet corners. An empty field gives zeros.
mesh::Field resampled(const mesh::Field& field, int columns, int rows);

// Gives samples that are no numbers what is around them, smoothly; wide holes take it from farther away. Where there is
// no number at all, nothing changes.
void fill_holes(mesh::Field& field);

// Bends a heightfield's broad course to that of a mask of wished heights (of any size; it is resampled), and keeps what
// the field has finer than reach samples: the mask is met in the mean over (2 reach + 1) squared samples. Returns the
// largest difference that is left between the two means, in heights.
float follow_mask(mesh::Field& height, const mesh::Field& mask, int reach);

}  // namespace quadrat::synthesis::land
