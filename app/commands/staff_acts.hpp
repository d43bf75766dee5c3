// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "desk/desk.hpp"

// What staff do to an exhibit from beside it, by the desk or by a broker, and the list of it.
namespace quadrat::commands {

inline constexpr const char* kActsNoted = "desk.log";  // in the state folder

// A line, with its date; a long list is kept as desk.log.1. `by` is for the log alone. What cannot be written there is
// warned of.
void note_act(const std::filesystem::path& state, const std::string& by, const std::string& what);

// Makes a file that the exhibit looks for (staff/watch.hpp). Throws InputError.
void ask_by(const std::filesystem::path& file);

// Throws InputError where no exhibit runs that could do it; it can be woken all the same.
void do_act(const std::filesystem::path& runtime, desk::Act act);

}  // namespace quadrat::commands
