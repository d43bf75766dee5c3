// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

#include "display/display.hpp"

namespace quadrat::display {

// A window of the desktop (X11 or Wayland): of options.size, or without a size the whole monitor with the cursor
// hidden. One at a time in a process. Throws InputError naming the remedy when there is no desktop to open it on.
std::unique_ptr<Display> open_window(const DisplayOptions& options, std::string why);

}  // namespace quadrat::display
