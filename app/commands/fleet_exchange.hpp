// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "fleet/exchange.hpp"
#include "site/configuration.hpp"

namespace quadrat::commands {

// What the exhibit beside us shares of what its visitors bred, by the settings in `file` and what its curator says over
// them: favourites that were bred here, then what was bred last; never what is hidden. What others share lies in the
// state folder (staff::kGuests), where the exhibit and its desk find it.
fleet::Sharing sharing_by(const site::Configuration::Fleet& settings, const std::filesystem::path& file,
                          const std::filesystem::path& state, const std::filesystem::path& runtime);

}  // namespace quadrat::commands
