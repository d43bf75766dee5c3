// SPDX-License-Identifier: Apache-2.0
#include "stage/asked.hpp"

#include <fmt/format.h>

#include "exhibit/family.hpp"
#include "stage/spoken.hpp"

namespace quadrat::stage {

Asked asked_to_slide(const Spoken& spoken, std::string_view name, std::optional<genome::WordId> word, double share) {
    ShownSlider shown{"", std::string(name), static_cast<float>(share)};
    if (word) shown.low = spoken.language().end(*word, false);
    if (word) shown.high = spoken.language().end(*word, true);
    return {"slide", {"←", "→", "−", "+"}, shown};
}

std::optional<Asked> asked_of(const exhibit::State& state, const exhibit::Timings& timings, const Spoken& spoken,
                              std::optional<genome::WordId> word) {
    if (state.screen == exhibit::Screen::Language)
        return Asked{"ask.language", spoken.labels(state.first_language), std::nullopt};
    if (state.screen == exhibit::Screen::Describe && word)
        return Asked{fmt::format("describe.{}", name_of(genome::word(*word).aspect)), spoken.language().answers(*word),
                     std::nullopt};
    const bool may_go_on = state.family.size() < exhibit::kMostFamily;
    const std::string goes_on = may_go_on ? spoken.said("go-on") : "";
    if (state.screen == exhibit::Screen::Finale && state.finale_asks) {
        const std::string_view print = state.is_printed ? "printing" : "print";
        const std::string prints = timings.can_print ? spoken.said(std::string(print)) : "";
        return Asked{"finale",
                     {spoken.said("family"), goes_on, prints, spoken.said("done")},
                     std::nullopt,
                     {"family", "go-on", print, "done"}};
    }
    if (state.screen != exhibit::Screen::Family) return std::nullopt;
    const auto leads = [&](exhibit::Choice button) {
        return exhibit::step_to(state.family, state.walked, button, state.here).has_value();
    };
    return Asked{"family",
                 {leads(exhibit::Choice::A) ? "←" : "", leads(exhibit::Choice::B) ? "→" : "",
                  leads(exhibit::Choice::C) ? "↕" : "", goes_on},
                 std::nullopt,
                 {"", "", "", "go-on"}};
}

}  // namespace quadrat::stage
