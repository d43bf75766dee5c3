// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "nursery/wall.hpp"
#include "site/configuration.hpp"

namespace quadrat::commands {

// What hangs on a wall beside an exhibit whose state folder this is: what staff chose, then what visitors bred, the
// worthiest first; nothing that is hidden. Reads both anew whenever it is called. `settings`: the exhibit's, as they
// are now.
nursery::Wall::Read works_beside(const std::filesystem::path& state, const site::Configuration& settings);

}  // namespace quadrat::commands
