// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "display/display.hpp"

namespace quadrat::display {

// GLFW's key token as ours; nothing for keys that mean nothing here.
std::optional<Key> key_from_glfw(int token);

}  // namespace quadrat::display
