// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "display/display.hpp"
#include "site/configuration.hpp"

namespace quadrat::site {

// The screen that the site asks for. Throws InputError.
display::DisplayOptions display_options(const Configuration& configuration);

// Where presses come from on a kind of display ("kms", "window", "headless") when the settings name nothing.
std::vector<std::string> default_inputs(std::string_view display_kind);

}  // namespace quadrat::site
