// SPDX-License-Identifier: Apache-2.0
#include "kiosk/captures.hpp"

#include <fmt/format.h>

#include "base/log.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::kiosk {

void Captures::keep(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now) {
    keep_earlier_landscape(theatre, canvas, now);
    keep_bred(theatre, canvas);
    const exhibit::Screen screen = parts_.show.state().screen;
    const nursery::Act& act = parts_.show.on_stage();
    const bool is_seen =
        screen == exhibit::Screen::Ask || screen == exhibit::Screen::Slide || screen == exhibit::Screen::Finale;
    if (is_seen) round_ = parts_.show.state().rounds + 1;
    // Whoever answers before its light is refined still finds it in the album.
    const bool is_worth_it = (is_seen && parts_.show.is_refined()) || screen == exhibit::Screen::Breed;
    // Acts come one after another; what is still on stage when a visit begins is of the visit before.
    if (parts_.album == nullptr || !is_worth_it || act.number <= photographed_ || act.recipes.empty()) return;
    photographed_ = act.number;
    const pictures::Picture picture = stage::picture_of(act, canvas, parts_.configuration);
    const bool is_finale = screen == exhibit::Screen::Finale;
    const std::string name =
        is_finale ? fmt::format("finale-{:02}", ++finales_) : fmt::format("generation-{:02}", ++generations_);
    const std::string caption = is_finale ? "The finale" : fmt::format("Round {}", round_);
    parts_.album->add(name, theatre.photograph(act, picture, canvas), picture, caption);
    base::log::info("picture {} of round {}", name + ".png", is_finale ? round_ - 1 : round_);
}

// Of a finale, while it is seen: one frame of it is drawn once more for the picture.
void Captures::keep_earlier_landscape(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now) {
    const nursery::Act& act = parts_.show.on_stage();
    const bool is_finale = parts_.show.state().screen == exhibit::Screen::Finale && !act.recipes.empty();
    if (parts_.keepsakes == nullptr || parts_.caretaker == nullptr || parts_.mode == staff::Mode::Safe) return;
    if (!is_finale || !parts_.show.is_refined() || !parts_.keepsakes->wants_another(now)) return;
    const mesh::Image picture = theatre.photograph(act, stage::picture_of(act, canvas, parts_.configuration), canvas);
    parts_.caretaker->keep_picture(staff::halved(picture), parts_.keepsakes->keep(now));
}

// When its visitor has gone: a frame's time is nobody's then.
void Captures::keep_bred(stage::Theatre& theatre, const display::Canvas& canvas) {
    if (parts_.caretaker == nullptr || parts_.configuration.desk.listen.empty()) return;
    const nursery::Act& act = parts_.show.act_of(exhibit::Screen::Finale);
    if (parts_.show.state().screen != exhibit::Screen::Attract || act.recipes.empty() || act.number <= collected_)
        return;
    collected_ = act.number;
    parts_.caretaker->keep_bred(theatre.photograph(act, stage::picture_of(act, canvas, parts_.configuration), canvas),
                                genome::code_of(act.recipes.front()));
}

}  // namespace quadrat::kiosk
