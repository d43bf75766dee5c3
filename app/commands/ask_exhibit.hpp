// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

// What a tool asks of a running exhibit: by files in its runtime folder (staff/watch.hpp).
namespace quadrat::commands {

// A picture of what it shows just now, as PNG, at full size; waits for it up to ten seconds. Throws InputError: no
// exhibit runs, it does not answer, or its screen is dark as planned.
std::string picture_of_exhibit(const std::filesystem::path& runtime);

}  // namespace quadrat::commands
