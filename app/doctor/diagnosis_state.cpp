// SPDX-License-Identifier: Apache-2.0
#include "doctor/diagnosis_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "archive/state_file.hpp"
#include "archive/state_lock.hpp"
#include "backup/staged.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "breeding/words/lessons.hpp"
#include "doctor/diagnosis_access.hpp"
#include "firmware-io/hid/mapping.hpp"
#include "staff/evidence.hpp"

namespace quadrat::doctor {
namespace {

namespace fs = std::filesystem;
using archive::Condition;

constexpr std::size_t kFaultsTold = 3;

Finding found(Health health, std::string what, std::string remedy = "") {
    return {"state", health, std::move(what), std::move(remedy)};
}

bool is_database(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    char head[16] = {};
    return stream.read(head, sizeof head) && std::string_view(head, 15) == "SQLite format 3";
}

// The newest of what is kept lies in the log beside the file.
std::string sizes(const archive::StateReport& report) {
    const auto kB = [](std::uintmax_t bytes) { return (bytes + 1023) / 1024; };
    if (report.log_bytes == 0) return fmt::format("{} kB", kB(report.file_bytes));
    return fmt::format("{} kB, and {} kB in its log beside it (-wal)", kB(report.file_bytes), kB(report.log_bytes));
}

Finding state_file_finding(const fs::path& file, const std::optional<machine::Account>& exhibit) {
    const archive::StateReport report = archive::examine_state_file(file);
    const std::string name = file.string();
    constexpr const char* kSetAside =
        "the exhibit sets it aside at its next start, under a dated name, and begins a fresh one; to have it back: "
        "quadrat state --restore FILE, from a backup";
    if (report.condition == archive::Condition::Missing) return found(Health::Good, "no visit has been kept yet");
    if (report.condition == archive::Condition::Damaged && !is_database(file))
        return found(Health::Doubtful, name + " is not a database any more", kSetAside);
    if (!is_usable(file, exhibit))
        return found(
            Health::Bad, fmt::format("{} is somebody else's: the exhibit may not write it", name),
            "visits are kept in memory only; give it to the exhibit's user: systemd-tmpfiles --create quadrat.conf");
    switch (report.condition) {
        case archive::Condition::Damaged:
            return found(Health::Doubtful, fmt::format("{} is damaged: {}", name, report.what), kSetAside);
        case archive::Condition::Newer:
            return found(Health::Doubtful, fmt::format("{}: {}", name, report.what),
                         "this program sets it aside at its next start and begins a fresh one: install the program "
                         "that wrote it, or move the file there with quadrat state --move-to");
        case archive::Condition::Unreadable:
            return found(Health::Doubtful, fmt::format("{} cannot be looked into: {}", name, report.what),
                         "run this as root");
        default:
            return found(Health::Good,
                         fmt::format("{}, {}{}", name, sizes(report), report.what.empty() ? "" : "; " + report.what));
    }
}

// "": it can be used, or is not there.
template <typename Read>
std::string trouble_of(const fs::path& file, const Read& read) {
    std::error_code error;
    if (!fs::exists(file, error)) return "";
    try {
        read(file);
        return "";
    } catch (const base::InputError& why) {
        return why.what();
    } catch (const std::invalid_argument& why) {
        return why.what();
    }
}

std::string trouble_of_words(const fs::path& file) {
    return trouble_of(file,
                      [](const fs::path& read) { breeding::word_lessons_from(base::read_file(read), read.string()); });
}

void examine_words(const fs::path& directory, std::vector<Finding>& findings) {
    const std::string now = trouble_of_words(directory / "words.json");
    const std::string before = trouble_of_words(directory / "words.previous.json");
    if (!now.empty())
        findings.push_back(found(Health::Doubtful, now,
                                 "the default map of words is used: put words.previous.json in its place, restore a "
                                 "backup (quadrat state --restore FILE), or delete it"));
    if (!before.empty())
        findings.push_back(found(Health::Doubtful, before, "it is used by nobody but as a copy: delete it"));
}

void examine_map(const fs::path& directory, std::vector<Finding>& findings) {
    const std::string trouble =
        trouble_of(directory / "buttons.map", [](const fs::path& file) { firmware_io::hid::read_mappings(file); });
    if (!trouble.empty())
        findings.push_back(found(Health::Doubtful, trouble,
                                 "the usual order of buttons is used: quadrat doctor --learn-buttons, or restore a "
                                 "backup (quadrat state --restore FILE)"));
}

void examine_set_aside(const fs::path& directory, std::vector<Finding>& findings) {
    std::vector<std::string> names;
    for (const fs::path& path : entries_of(directory)) {
        const std::string name = path.filename().string();
        const bool is_part = name.ends_with("-wal") || name.ends_with("-shm");
        if (name.find(".damaged-") != std::string::npos && !is_part) names.push_back(name);
    }
    if (names.empty()) return;
    std::ranges::sort(names);
    findings.push_back(
        found(Health::Doubtful,
              fmt::format("{} in {} {} set aside, the last: {}", names.size(), directory.string(),
                          names.size() == 1 ? "was" : "were", names.back()),
              "what was kept until then is in there: restore a backup (quadrat state --restore FILE), or "
              "move it out of the folder once nobody needs it"));
}

void examine_holder(const fs::path& directory, std::vector<Finding>& findings) {
    if (const auto holder = archive::holder_of(directory))
        findings.push_back(found(Health::Good, fmt::format("in use by {}", to_text(*holder))));
    if (backup::is_interrupted(directory))
        findings.push_back(found(Health::Doubtful, "a restore was interrupted", "the next start completes it"));
}

void tell_faults(const fs::path& directory, std::vector<Finding>& findings) {
    const std::vector<staff::KeptFault> faults = staff::read_faults(directory);
    const std::size_t told = std::min(kFaultsTold, faults.size());
    for (std::size_t i = faults.size() - told; i < faults.size(); ++i)
        findings.push_back(found(Health::Good, "a fault that is kept: " + staff::to_line(faults[i])));
}

}  // namespace

std::vector<Finding> examine_state_files(const fs::path& directory, const std::optional<machine::Account>& exhibit) {
    std::vector<Finding> findings{state_file_finding(directory / archive::kStateFile, exhibit)};
    examine_words(directory, findings);
    examine_map(directory, findings);
    examine_set_aside(directory, findings);
    examine_holder(directory, findings);
    tell_faults(directory, findings);
    return findings;
}

}  // namespace quadrat::doctor
