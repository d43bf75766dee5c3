// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string_view>

namespace quadrat::base {

// How many bytes the character at the start of the text takes, 1 to 4, by Unicode's table 3-7: no overlong form, no
// surrogate, nothing beyond U+10FFFF. 0 where there is none, or no text.
std::size_t utf8_length(std::string_view text);

}  // namespace quadrat::base
