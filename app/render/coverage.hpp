// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace quadrat::render {

// The letters of a text for which no installed font has a shape, each once, in their order: on the screen they would be
// boxes. "" when all of it can be drawn. Controls other than the end of a line count as letters without a shape.
std::string letters_without_font(const std::string& utf8);

}  // namespace quadrat::render
