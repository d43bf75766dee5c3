// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "exhibit/visit.hpp"

namespace quadrat::exhibit {

Prompt prompt_of(const State& state) {
    switch (state.screen) {
        case Screen::Attract:
            return Prompt::PressAnyButton;
        case Screen::Breed:
            return Prompt::Growing;
        case Screen::StillThere:
            return Prompt::StillThere;
        case Screen::Finale:
            return Prompt::YourLandscape;
        case Screen::Describe:
            return Prompt::WhichWords;
        case Screen::Slide:
            return Prompt::TurnWords;
        case Screen::Language:
            return Prompt::WhichLanguage;
        case Screen::Ask:
            break;
    }
    constexpr genome::PerAspect<Prompt> kQuestions{{Prompt::BestTrees, Prompt::BestLand, Prompt::BestSky}};
    return kQuestions[state.question];
}

std::optional<LanguageChoice> language_on(Choice button, int first_language, int languages) {
    if (button == Choice::Back) return std::nullopt;
    constexpr int kButtons = 4;
    const int place = static_cast<int>(button);
    const bool has_pages = languages > kButtons;
    if (has_pages && button == Choice::D) {
        const int next = first_language + kButtons - 1;
        return LanguageChoice{next < languages ? next : 0, true};
    }
    if (first_language + place >= languages) return std::nullopt;
    return LanguageChoice{first_language + place, false};
}

std::optional<int> countdown_s(const State& state, Instant now, const Timings& timings) {
    if (state.screen != Screen::StillThere) return std::nullopt;
    const Instant left = state.since + timings.countdown - std::max(now, state.since);
    return static_cast<int>(std::chrono::ceil<std::chrono::seconds>(std::max(left, Instant{0})).count());
}

}  // namespace quadrat::exhibit
