// SPDX-License-Identifier: Apache-2.0
#include "kiosk/preview.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "genome/speech.hpp"

namespace quadrat::kiosk {
namespace {

using exhibit::Screen;
using genome::Aspect;

// Where a prompt stands. What is not here stands below others, or on a board; it is shown as a question is.
struct Place {
    std::string_view prompt;
    Screen screen;
    Aspect question = Aspect::Trees;
};
constexpr std::array kPlaces{Place{"attract", Screen::Attract},
                             Place{"ask.language", Screen::Language},
                             Place{"ask.trees", Screen::Ask},
                             Place{"ask.land", Screen::Ask, Aspect::Land},
                             Place{"ask.sky", Screen::Ask, Aspect::Sky},
                             Place{"breed", Screen::Breed},
                             Place{"still-there", Screen::StillThere},
                             Place{"finale", Screen::Finale}};

}  // namespace

mesh::Image preview_of(const staff::PreviewWish& wish, const Show& show, stage::Theatre& theatre,
                       const site::Configuration& configuration, const display::Canvas& canvas, base::Instant now) {
    if (std::ranges::find(genome::kPrompts, wish.prompt) == genome::kPrompts.end()) return {};
    site::Configuration wished = configuration;
    wished.visit.language = wish.language;
    wished.texts.clear();
    wished.texts_in[wish.language] = wish.texts;
    exhibit::State state = show.state();
    const auto* place = std::ranges::find(kPlaces, std::string_view(wish.prompt), &Place::prompt);
    state.screen = place == kPlaces.end() ? Screen::Describe : place->screen;
    if (place != kPlaces.end()) state.question = place->question;
    state.since = state.last_press = now;
    const nursery::Act* act = &show.programme().act_of(state.screen);
    if (act->scenes.empty()) act = &show.on_stage();  // nobody has bred anything yet
    stage::Moment moment{state, show.timings(), *act, std::nullopt, std::nullopt};
    if (place == kPlaces.end() || state.screen == Screen::Language)
        moment.asked = stage::Asked{wish.prompt, {}, std::nullopt};
    moment.language = wish.language;
    moment.now = now;
    const stage::Board closed{site::text(wished, "closed"), {}, stage::Board::Cover::Tint, false, "closed"};
    stage::Theatre::Over over;
    if (wish.prompt == "closed") over.board = &closed;
    if (wish.prompt == "settings") over.sign = site::text(wished, "settings");
    return theatre.sketch(moment, canvas, over, wished);
}

}  // namespace quadrat::kiosk
