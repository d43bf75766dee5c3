// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "doctor/diagnosis.hpp"
#include "machine/account.hpp"

namespace quadrat::doctor {

inline constexpr const char* kCrashFolder = "/var/lib/systemd/coredump";

// The last crash of the exhibit's user that systemd-coredump keeps in this folder, and how to read it: doubtful for a
// week, good from then on. Nothing to say where none is kept, or there is no such user.
std::vector<Finding> examine_crashes(const std::filesystem::path& folder,
                                     const std::optional<machine::Account>& exhibit,
                                     std::chrono::system_clock::time_point now);

}  // namespace quadrat::doctor
