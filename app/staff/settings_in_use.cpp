// SPDX-License-Identifier: Apache-2.0
#include "staff/settings_in_use.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace quadrat::staff {

SettingsInUse::SettingsInUse(site::Settings begun_with)
    : news_{begun_with.from, std::move(begun_with.mistakes), ""},
      toml_(std::move(begun_with.toml)),
      is_settled_(begun_with.from != site::SettingsFrom::File || begun_with.file.empty()) {}

void SettingsInUse::follow(std::string toml, std::string after_restart) {
    // What waits for a restart is not proved by anything that is seen now.
    is_settled_ = !after_restart.empty();
    news_ = {site::SettingsFrom::File, {}, std::move(after_restart)};
    toml_ = std::move(toml);
    shown_since_.reset();
}

void SettingsInUse::refuse(std::vector<site::Mistake> mistakes) { news_.mistakes = std::move(mistakes); }

std::optional<std::string> SettingsInUse::take_proved(Instant now, bool is_shown) {
    if (is_settled_ || !is_shown) {
        shown_since_.reset();
        return std::nullopt;
    }
    if (!shown_since_) shown_since_ = now;
    if (now - *shown_since_ < kProof) return std::nullopt;
    is_settled_ = true;
    return toml_;
}

std::vector<std::string> lines_for_staff(const SettingsNews& news) {
    constexpr std::size_t kMost = 3;
    std::vector<std::string> lines;
    if (news.mistakes.empty()) return lines;
    lines.push_back(fmt::format("SETTINGS: {}", site::in_words(news.from)));
    const std::size_t told = std::min(kMost, news.mistakes.size());
    for (std::size_t i = 0; i < told; ++i) {
        const site::Mistake& mistake = news.mistakes[i];
        const std::string line = mistake.line > 0 ? fmt::format(", line {}", mistake.line) : "";
        lines.push_back(fmt::format("{}{}: {}", mistake.file, line, mistake.what));
        if (!mistake.remedy.empty()) lines.push_back("  → " + mistake.remedy);
    }
    if (told < news.mistakes.size())
        lines.push_back(fmt::format("and {} more: quadrat doctor --only settings", news.mistakes.size() - told));
    return lines;
}

}  // namespace quadrat::staff
