// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace quadrat::base {

// Text as it may stand between the tags of SVG and HTML, and in their attributes: the one way any text gets there.
// Takes any bytes; what XML forbids, control characters and bytes that are no UTF-8, becomes U+FFFD.
std::string escaped(std::string_view text);

}  // namespace quadrat::base
