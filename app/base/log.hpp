// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace quadrat::base {

// The program's log goes to stderr (the journal, when it runs as a service), one line an event:
//     base::log::info("round {} shown after {} ms", round, ms);
namespace log = spdlog;

enum class LogDetail { Quiet, Normal, Verbose };

// Once, at start.
void open_log(LogDetail detail);

// From now on every line is written there too, after what is in the file already. At 4 MB, log.txt becomes log.1.txt
// and a new one is begun; three of before are kept. Throws InputError naming the file where it cannot be written.
void log_to_file_too(const std::filesystem::path& file);

struct Warning {
    std::chrono::system_clock::time_point at;
    std::string text;
};

// The last warnings and errors of this run, oldest first, and how many there were altogether.
struct RecentWarnings {
    std::vector<std::string> lines;  // with the time of day
    std::vector<Warning> warnings;   // the same
    std::size_t count = 0;
};
RecentWarnings recent_warnings();

}  // namespace quadrat::base
