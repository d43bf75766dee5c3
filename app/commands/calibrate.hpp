// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "site/configuration.hpp"

namespace quadrat::commands {

// Measures what this machine's GPU draws, on the screen it would draw for, and keeps in the state folder where the
// exhibit is to start. Returns the exit status. Throws InputError where nothing can be opened.
int calibrate(const site::Configuration& configuration, const std::filesystem::path& state);

}  // namespace quadrat::commands
