// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "doctor/diagnosis.hpp"
#include "machine/account.hpp"

// Who may use what, for the diagnosis. Without the exhibit's own user, whoever runs us is meant.
namespace quadrat::doctor {

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);  // sorted; none: it is not there

bool is_usable(const std::filesystem::path& path, const std::optional<machine::Account>& exhibit);

struct Nodes {
    const char* subject;  // of the finding
    const char* kind;     // "GPIO chips"
    const char* prefix;   // of their names
    const char* group;    // whose they usually are
};
Finding access_finding(const Nodes& nodes, const std::filesystem::path& dev,
                       const std::optional<machine::Account>& exhibit);

// "usermod -aG gpio quadrat", for people.
std::string joining(const char* group, const std::optional<machine::Account>& exhibit);

}  // namespace quadrat::doctor
