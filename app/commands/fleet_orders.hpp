// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "fleet/orders.hpp"

namespace quadrat::commands {

// What a broker may ask of the exhibit beside us, done as the desk does it: by files that it looks for, and in the
// curator's settings over `file`, the site's. Each is in the list of what was done, and the settings can be taken back.
fleet::Orders fleet_orders(const std::filesystem::path& file, const std::filesystem::path& state,
                           const std::filesystem::path& runtime);

}  // namespace quadrat::commands
