// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "archive/state_lock.hpp"

namespace quadrat::backup {

// For a tool that writes to a state folder: held until it ends. A restore that was interrupted is completed first.
// Throws InputError naming who holds it, and what ends that.
archive::StateLock hold_state(const std::filesystem::path& folder, const std::string& tool);

enum class Starter {
    Service,  // starts us again and again, so that it is better to wait than to end
    Hand,
};

struct ExhibitsHold {
    std::optional<archive::StateLock> lock;  // without one, nothing can be kept there either, and the show goes on
    bool was_stopped = false;                // told to end while it waited
};

// The same for the exhibit; its folder is made where it is missing. Where somebody else holds it: the service waits and
// says so once, whoever starts it by hand is refused with InputError.
ExhibitsHold hold_state_for_the_exhibit(const std::filesystem::path& folder, Starter starter,
                                        const std::atomic<bool>& stop);

}  // namespace quadrat::backup
