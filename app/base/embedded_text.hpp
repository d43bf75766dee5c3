// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

namespace quadrat::base {

// A data file that travels inside the binary.
struct EmbeddedText {
    std::string_view name;  // its file's name without the ending
    std::string_view text;
};

}  // namespace quadrat::base
