// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "report/writers.hpp"

namespace quadrat::commands {

// What visitors did, by the machine's time zone: the house's. Throws InputError.
report::Counts count_visits(const std::filesystem::path& state, const report::Days& days);

// Of a report that is made now.
report::Heading heading_of(const std::string& title);

}  // namespace quadrat::commands
