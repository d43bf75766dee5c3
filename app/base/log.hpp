// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/core.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::base {

// The program's log goes to stderr (the journal, when it runs as a service), one line an event:
//     base::log::info("round {} shown after {} ms", round, ms);
// A text alone is written as it is. spdlog stays behind it, for its headers take a compiler longer than most files do.
namespace log {

enum class Level { Debug, Info, Warning, Error };

void write(Level level, std::string_view text);
void write_formatted(Level level, fmt::string_view text, fmt::format_args values);

inline void debug(std::string_view text) { write(Level::Debug, text); }
inline void info(std::string_view text) { write(Level::Info, text); }
inline void warn(std::string_view text) { write(Level::Warning, text); }
inline void error(std::string_view text) { write(Level::Error, text); }

template <typename First, typename... Rest>
void debug(fmt::format_string<First, Rest...> text, First&& first, Rest&&... rest) {
    write_formatted(Level::Debug, text, fmt::make_format_args(first, rest...));
}
template <typename First, typename... Rest>
void info(fmt::format_string<First, Rest...> text, First&& first, Rest&&... rest) {
    write_formatted(Level::Info, text, fmt::make_format_args(first, rest...));
}
template <typename First, typename... Rest>
void warn(fmt::format_string<First, Rest...> text, First&& first, Rest&&... rest) {
    write_formatted(Level::Warning, text, fmt::make_format_args(first, rest...));
}
template <typename First, typename... Rest>
void error(fmt::format_string<First, Rest...> text, First&& first, Rest&&... rest) {
    write_formatted(Level::Error, text, fmt::make_format_args(first, rest...));
}

}  // namespace log

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
