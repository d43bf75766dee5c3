// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"
#include "kiosk/configuration.hpp"

namespace quadrat::kiosk {

// The screen that the site asks for. Throws InputError.
display::DisplayOptions display_options(const Configuration& configuration);

}  // namespace quadrat::kiosk
