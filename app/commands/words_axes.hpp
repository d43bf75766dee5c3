// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

namespace quadrat::commands {

// Measures the detail axes of the word map that comes along, by pictures, and writes DIRECTORY/trees.json, land.json
// and sky.json.
int measure_axes(const std::filesystem::path& directory);

}  // namespace quadrat::commands
