// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "site/mistake.hpp"

namespace quadrat::site {

// A file of settings as a table, with a mistake for each line that is no TOML; what such a line says is left out.
struct ParsedToml {
    toml::table root;
    std::vector<Mistake> mistakes;
    bool is_whole = true;  // false: nothing sure can be said of what follows the last mistake, and `root` is empty
};
ParsedToml parse_toml(std::string_view text, const std::string& source);

}  // namespace quadrat::site
