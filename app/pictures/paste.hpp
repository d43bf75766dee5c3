// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/image.hpp"

namespace quadrat::pictures {

// Lays a premultiplied RGBA image over another, as far as it fits.
void paste(const mesh::Image& over, mesh::Image& onto, int left, int top);

}  // namespace quadrat::pictures
