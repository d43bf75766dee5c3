// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

namespace quadrat::machine {

// What systemd says of a unit, in its own words.
struct UnitState {
    std::string load;    // "loaded", "not-found", "masked"
    std::string file;    // "enabled", "disabled"
    std::string active;  // "active", "inactive", "activating", "failed"
    std::string result;  // of its last end: "success", "exit-code", "watchdog"
};

// Nothing: systemd does not answer here.
std::optional<UnitState> read_unit_state(const std::string& unit);

}  // namespace quadrat::machine
