// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "exhibit/family.hpp"
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
        case Screen::Family:
            return Prompt::WhichAncestor;
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

bool asks(const State& state) {
    switch (state.screen) {
        case Screen::Ask:
        case Screen::Describe:
        case Screen::Slide:
        case Screen::Language:
        case Screen::Family:
            return true;
        case Screen::Finale:
            return state.finale_asks;
        default:
            return false;
    }
}

std::array<bool, 4> meant_by(const State& state, const Timings& timings) {
    std::array<bool, 4> meant{true, true, true, true};
    const bool may_go_on = state.family.size() < kMostFamily;
    if (state.screen == Screen::Finale && state.finale_asks) return {true, may_go_on, timings.can_print, true};
    for (std::size_t i = 0; i < meant.size(); ++i) {
        const auto button = static_cast<Choice>(i);
        if (state.screen == Screen::Language)
            meant[i] = language_on(button, state.first_language, timings.languages).has_value();
        if (state.screen == Screen::Family)
            meant[i] =
                button == Choice::D ? may_go_on : step_to(state.family, state.walked, button, state.here).has_value();
    }
    return meant;
}

TakingTurns turns_named(std::string_view name) {
    if (name == "never") return TakingTurns::Never;
    return name == "always" ? TakingTurns::Always : TakingTurns::Found;
}

bool takes_turns(const State& state, const Timings& timings) {
    if (timings.turns == TakingTurns::Always) return true;
    return timings.turns == TakingTurns::Found && state.crossings >= kCrossingsOfAGroup;
}

bool is_last_round(const State& state, const Timings& timings) {
    return state.rounds + 1 >= timings.rounds + std::max(0, timings.rounds_more);
}

std::optional<int> countdown_s(const State& state, Instant now, const Timings& timings) {
    const bool is_question = state.screen == Screen::StillThere;
    const bool is_silent = state.screen == Screen::Family || state.screen == Screen::Describe ||
                           state.screen == Screen::Language || (state.screen == Screen::Finale && state.finale_asks);
    if (!is_question && !is_silent) return std::nullopt;
    const Instant until = next_deadline(state, timings).value();
    const Instant left = std::max(until - std::max(now, state.since), Instant{0});
    // Of a short time its second half.
    const Instant whole = until - std::max(state.since, state.last_press);
    if (!is_question && left > std::min<Instant>(timings.countdown, whole / 2)) return std::nullopt;
    return static_cast<int>(std::chrono::ceil<std::chrono::seconds>(left).count());
}

}  // namespace quadrat::exhibit
