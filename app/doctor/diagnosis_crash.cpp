// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis_crash.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <regex>
#include <system_error>

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

// core.COMMAND.USER.BOOT.PROCESS.MICROSECONDS, and how it is compressed. A thread may be the COMMAND, so the user says
// whose it is.
std::optional<Clock::time_point> crash_time(const std::string& name, uid_t user) {
    static const std::regex pattern(R"(core\..+\.(\d+)\.[0-9a-f]{32}\.\d+\.(\d+)(\.\w+)?)");
    std::smatch parts;
    if (!std::regex_match(name, parts, pattern) || parts[1] != std::to_string(user)) return {};
    const std::string digits = parts[2];
    std::int64_t since_1970_us = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), since_1970_us);
    if (read.ec != std::errc{}) return {};
    return Clock::time_point(std::chrono::microseconds(since_1970_us));
}

std::string in_local_time(Clock::time_point time) {
    const std::time_t seconds = Clock::to_time_t(time);
    std::tm local{};
    ::localtime_r(&seconds, &local);
    return fmt::format("{:%Y-%m-%d %H:%M}", local);
}

}  // namespace

std::vector<Finding> examine_crashes(const fs::path& folder, const std::optional<machine::Account>& exhibit,
                                     Clock::time_point now) {
    if (!exhibit) return {};
    std::optional<Clock::time_point> last;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        last = std::max(last, crash_time(at->path().filename().string(), exhibit->user));
    if (!last) return {};
    const bool is_recent = now - *last < std::chrono::days(7);
    return {{"service", is_recent ? Health::Doubtful : Health::Good,
             fmt::format("it crashed on {}, and what it was doing is kept", in_local_time(*last)),
             "read it, and send it to whoever mends it: sudo coredumpctl info /usr/bin/quadrat"}};
}

}  // namespace quadrat::doctor
