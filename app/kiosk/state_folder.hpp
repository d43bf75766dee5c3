// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

namespace quadrat::kiosk {

// Where visits are kept: the named folder, else the service's ($STATE_DIRECTORY), else the user's.
std::filesystem::path state_folder(const std::string& named);

}  // namespace quadrat::kiosk
