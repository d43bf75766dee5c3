// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "desk/desk.hpp"
#include "site/configuration.hpp"

namespace quadrat::commands {

struct DeskPlaces {
    std::string named_configuration, named_state;  // as on the command line; "" for the service's
    std::filesystem::path state, runtime;
    std::filesystem::path log;  // of an exhibit that was started by hand; "" for the service's journal
};

inline constexpr const char* kPassphraseFile = "desk.passphrase";   // in the state folder
inline constexpr const char* kBroughtFile = "desk-brought.tar.xz";  // likewise: a file while it comes

// What the desk tells and does, beside an exhibit that runs or does not.
desk::Sources desk_sources(const DeskPlaces& places, const site::Configuration& configuration);

}  // namespace quadrat::commands
