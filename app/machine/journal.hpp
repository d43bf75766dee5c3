// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace quadrat::machine {

// The last lines that a unit ("quadrat.service") wrote to the system's journal, and what was said of it there, the
// newest last: "2026-11-26 11:20:33 UTC warning: the text". Empty where there is no journal or none that we may read.
// `folder`: of another journal than the system's.
std::vector<std::string> last_journal_lines(const std::string& unit, std::size_t most,
                                            const std::filesystem::path& folder = {});

}  // namespace quadrat::machine
