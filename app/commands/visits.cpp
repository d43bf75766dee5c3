// SPDX-License-Identifier: Apache-2.0
#include "commands/visits.hpp"

#include <ctime>

#include "archive/visit_rows.hpp"
#include "machine/version.hpp"
#include "site/wall_clock.hpp"

namespace quadrat::commands {
namespace {

report::LocalTime local_time_of(std::int64_t ms) {
    const std::time_t seconds = ms / 1000;
    std::tm local{};
    ::localtime_r(&seconds, &local);
    return {std::chrono::year(local.tm_year + 1900) / (local.tm_mon + 1) / local.tm_mday,
            local.tm_hour * 60 + local.tm_min};
}

}  // namespace

report::Counts count_visits(const std::filesystem::path& state, const report::Days& days) {
    report::Counts counts;
    archive::read_state(
        state, [&](const archive::Connection& connection) { counts = report::count(connection, days, local_time_of); });
    return counts;
}

report::Heading heading_of(const std::string& title) {
    return {title, site::time_text(site::read_wall_clock(site::LastTimeSeen(std::filesystem::path{}))),
            std::string(machine::version())};
}

}  // namespace quadrat::commands
