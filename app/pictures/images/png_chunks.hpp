// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

// PNG as a row of chunks (W3C, "Portable Network Graphics", third edition, section 5). Takes any bytes.
namespace quadrat::pictures {

// What is wrong with these bytes as a PNG, for a message: cut off, a wrong checksum, no pixels. "" where it is whole.
std::string damage_of_png(std::string_view png);

// The same picture with all of its texts before its pixels: many readers look no further than there. What is no whole
// PNG comes back as it is.
std::string with_texts_first(std::string png);

}  // namespace quadrat::pictures
