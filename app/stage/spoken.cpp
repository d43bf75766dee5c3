// SPDX-License-Identifier: Apache-2.0
#include "stage/spoken.hpp"

#include <algorithm>

namespace quadrat::stage {
namespace {

constexpr std::chrono::seconds kShown{4};  // each language, while nobody has chosen one

}  // namespace

void Spoken::follow(const site::Configuration& configuration) {
    const bool is_chosen = now_ != own_;
    own_ = configuration.visit.language;
    offered_ = configuration.visit.languages;
    texts_.texts = configuration.texts;
    texts_.texts_in = configuration.texts_in;
    texts_.visit.language = own_;
    if (!is_chosen || std::ranges::find(offered_, now_) == offered_.end()) now_ = own_;
}

void Spoken::choose(int which) { now_ = offered_.at(static_cast<std::size_t>(which)); }

void Spoken::resume(const std::string& code) {
    if (std::ranges::find(offered_, code) != offered_.end()) now_ = code;
}

const std::string& Spoken::shown(exhibit::Screen screen, base::Instant now) const {
    const bool is_anybodys = screen == exhibit::Screen::Attract || screen == exhibit::Screen::Language;
    if (!is_anybodys || offered_.size() < 2) return now_;
    return offered_[static_cast<std::size_t>(now / kShown) % offered_.size()];
}

std::array<std::string, 4> Spoken::labels(int first_language) const {
    std::array<std::string, 4> labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto choice = exhibit::language_on(static_cast<exhibit::Choice>(i), first_language, offered());
        if (!choice) continue;
        labels[i] =
            choice->turns_page ? "…" : genome::language(offered_[static_cast<std::size_t>(choice->which)]).name();
    }
    return labels;
}

std::array<std::string, 4> Spoken::codes(int first_language) const {
    std::array<std::string, 4> codes;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const auto choice = exhibit::language_on(static_cast<exhibit::Choice>(i), first_language, offered());
        if (choice && !choice->turns_page) codes[i] = offered_[static_cast<std::size_t>(choice->which)];
    }
    return codes;
}

}  // namespace quadrat::stage
