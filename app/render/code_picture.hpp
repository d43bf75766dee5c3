// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "mesh/image.hpp"

namespace quadrat::render {

// A QR code (ISO/IEC 18004) of the text, black on white, with the quiet zone of four modules that it needs. Of the
// error correction the least: nothing scratches a screen, and larger modules are read from farther away. RGBA, opaque,
// as large as fits into that many pixels a side with whole modules; an empty image where none would, or the text is too
// long.
mesh::Image code_picture(const std::string& text, int most_px);

}  // namespace quadrat::render
