// SPDX-License-Identifier: Apache-2.0
#include "kiosk/state_folder.hpp"

#include <cstdlib>

namespace quadrat::kiosk {

std::filesystem::path state_folder(const std::string& named) {
    if (!named.empty()) return named;
    if (const char* directory = std::getenv("STATE_DIRECTORY")) return directory;
    if (const char* state = std::getenv("XDG_STATE_HOME")) return std::filesystem::path(state) / "quadrat";
    if (const char* home = std::getenv("HOME")) return std::filesystem::path(home) / ".local/state/quadrat";
    return "quadrat-state";
}

}  // namespace quadrat::kiosk
