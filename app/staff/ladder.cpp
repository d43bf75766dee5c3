// SPDX-License-Identifier: Apache-2.0
#include "staff/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"

namespace quadrat::staff {
namespace {

constexpr std::size_t kStartsKept = 20;

// "123 well" or "123 open", a line each; anything else is nothing.
std::vector<Start> read_starts(const std::filesystem::path& file, Seconds now) {
    std::vector<Start> starts;
    std::ifstream stream(file);
    long long at = 0;
    std::string end;
    while (starts.size() < 10 * kStartsKept && stream >> at >> end) {
        // A file of another boot, where the folder was not emptied: its clock tells nothing.
        if (at < 0 || Seconds{at} > now) return {};
        starts.push_back({Seconds{at}, end == "well"});
    }
    return starts;
}

int read_count(const std::filesystem::path& file) {
    std::ifstream stream(file);
    int count = 0;
    return stream >> count ? std::clamp(count, 0, 1000) : 0;
}

bool write(const std::filesystem::path& file, const std::string& text) {
    try {
        base::write_file(file, text);
        return true;
    } catch (const base::InputError&) {
        return false;
    }
}

}  // namespace

Rung rung_of(const std::vector<Start>& before, Seconds now, int reboots) {
    Rung rung;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Seconds failed_by = i + 1 < before.size() ? before[i + 1].at : now;
        if (!before[i].has_ended_well && now - failed_by < kLadderSpan) ++rung.failures;
    }
    if (rung.failures >= kFailuresToSafety) rung.mode = Mode::Safe;
    if (rung.failures >= kFailuresToReboot && reboots < kMostReboots) rung.remedy = Remedy::Reboot;
    return rung;
}

Ladder::Ladder(const std::filesystem::path& runtime_folder, const std::filesystem::path& state_folder, Seconds now)
    : starts_file_(runtime_folder.empty() ? std::filesystem::path{} : runtime_folder / "starts"),
      reboots_file_(state_folder / "reboots") {
    starts_ = read_starts(starts_file_, now);
    reboots_ = read_count(reboots_file_);
    rung_ = rung_of(starts_, now, reboots_);
    starts_.push_back({now, false});
    if (starts_.size() > kStartsKept) starts_.erase(starts_.begin(), starts_.end() - kStartsKept);
    write_starts();
}

bool Ladder::write_starts() const {
    if (starts_file_.empty()) return false;
    std::string text;
    for (const Start& start : starts_)
        text += fmt::format("{} {}\n", start.at.count(), start.has_ended_well ? "well" : "open");
    return write(starts_file_, text);
}

bool Ladder::note_reboot() {
    ++reboots_;
    return write(reboots_file_, fmt::format("{}\n", reboots_));
}

void Ladder::note_good_run() {
    if (std::exchange(reboots_, 0) > 0) write(reboots_file_, "0\n");
}

void Ladder::keep_safe() {
    rung_.mode = Mode::Safe;
    rung_.is_wished = true;
}

void Ladder::forgive() {
    starts_.erase(starts_.begin(), starts_.end() - 1);
    rung_ = {};
    write_starts();
}

void Ladder::note_end() {
    starts_.back().has_ended_well = true;
    write_starts();
}

}  // namespace quadrat::staff
