// SPDX-License-Identifier: Apache-2.0
#include "machine/journal.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <systemd/sd-journal.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <string_view>

namespace quadrat::machine {
namespace {

constexpr std::size_t kLongestLine = 4096;  // bytes

struct Close {
    void operator()(sd_journal* journal) const { sd_journal_close(journal); }
};

std::string field_of(sd_journal* journal, const char* name) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    if (sd_journal_get_data(journal, name, &bytes, &size) < 0) return {};
    const std::string_view field(static_cast<const char*>(bytes), std::min(size, kLongestLine));
    return std::string(field.substr(std::min(field.find('=') + 1, field.size())));
}

std::string line_of(sd_journal* journal) {
    std::uint64_t at_us = 0;
    sd_journal_get_realtime_usec(journal, &at_us);
    const std::string priority = field_of(journal, "PRIORITY");
    const char* grave = priority.empty() || priority > "4" ? "" : priority == "4" ? "warning: " : "error: ";
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC {}{}", fmt::gmtime(static_cast<std::time_t>(at_us / 1'000'000)), grave,
                       field_of(journal, "MESSAGE"));
}

}  // namespace

std::vector<std::string> last_journal_lines(const std::string& unit, std::size_t most,
                                            const std::filesystem::path& folder) {
    sd_journal* opened = nullptr;
    const int status = folder.empty() ? sd_journal_open(&opened, SD_JOURNAL_LOCAL_ONLY | SD_JOURNAL_SYSTEM)
                                      : sd_journal_open_directory(&opened, folder.c_str(), 0);
    if (status < 0) return {};
    const std::unique_ptr<sd_journal, Close> journal(opened);
    // The service manager speaks of the unit under another name.
    const std::string own = "_SYSTEMD_UNIT=" + unit;
    const std::string of_it = "UNIT=" + unit;
    if (sd_journal_add_match(opened, own.data(), own.size()) < 0 || sd_journal_add_disjunction(opened) < 0 ||
        sd_journal_add_match(opened, of_it.data(), of_it.size()) < 0 || sd_journal_seek_tail(opened) < 0)
        return {};
    std::vector<std::string> lines;
    while (lines.size() < most && sd_journal_previous(opened) > 0) lines.push_back(line_of(opened));
    std::ranges::reverse(lines);
    return lines;
}

}  // namespace quadrat::machine
