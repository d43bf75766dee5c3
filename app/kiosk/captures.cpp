// SPDX-License-Identifier: Apache-2.0
#include "kiosk/captures.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/log.hpp"
#include "genome/scene_code.hpp"
#include "kiosk/preview.hpp"
#include "staff/watch.hpp"

namespace quadrat::kiosk {
namespace {

constexpr int kWholeWidth = 1 << 15;  // pixels, or whatever the frame has less

}  // namespace

void Captures::keep(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now) {
    keep_earlier_landscape(theatre, canvas, now);
    keep_bred(theatre, canvas);
    const exhibit::Screen screen = parts_.show.state().screen;
    const nursery::Act& act = parts_.show.on_stage();
    const bool is_seen =
        screen == exhibit::Screen::Ask || screen == exhibit::Screen::Slide || screen == exhibit::Screen::Finale;
    if (is_seen) round_ = parts_.show.state().rounds + 1;
    // Whoever answers before its light is refined still finds it in the album.
    const bool is_worth_it =
        (is_seen && parts_.show.programme().has_nothing_to_refine()) || screen == exhibit::Screen::Breed;
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
    if (parts_.mode == staff::Mode::Safe || !is_finale || !parts_.show.programme().has_nothing_to_refine() ||
        !parts_.keepsakes->wants_another(now))
        return;
    const mesh::Image picture = theatre.photograph(act, stage::picture_of(act, canvas, parts_.configuration), canvas);
    parts_.attendant->keep_picture(staff::halved(picture), parts_.keepsakes->keep(now));
}

// When its visitor has gone: a frame's time is nobody's then.
void Captures::keep_bred(stage::Theatre& theatre, const display::Canvas& canvas) {
    if (!site::collects_bred(parts_.configuration)) return;
    const nursery::Act& act = parts_.show.programme().act_of(exhibit::Screen::Finale);
    if (parts_.show.state().screen != exhibit::Screen::Attract || act.recipes.empty() || act.number <= collected_)
        return;
    collected_ = act.number;
    parts_.attendant->keep_bred(theatre.photograph(act, stage::picture_of(act, canvas, parts_.configuration), canvas),
                                genome::code_of(act.recipes.front()), parts_.show.caption());
}

void Captures::draw_preview(stage::Theatre& theatre, const display::Canvas& canvas, base::Instant now) {
    if (canvas.context == 0) return;
    const bool has_visitor = parts_.show.state().screen != exhibit::Screen::Attract;
    const auto wish = parts_.attendant->take_preview_wish(has_visitor);
    if (!wish) return;
    mesh::Image picture = preview_of(*wish, parts_.show, theatre, parts_.configuration, canvas, now);
    if (picture.width > 0) parts_.attendant->keep_picture(std::move(picture), staff::kPreview);
}

void Captures::answer(stage::Theatre& theatre) {
    const std::string file = parts_.attendant->take_picture_wish();
    const bool is_from_afar = file == staff::kGlance || file == staff::kPicture;
    // Where none can be begun yet, it is wished for again.
    if (is_from_afar && theatre.begin_glimpse(file == staff::kGlance ? staff::kGlanceWidth : kWholeWidth))
        glimpsed_ = file;
    else if (!file.empty() && !is_from_afar)
        parts_.attendant->keep_picture(theatre.read_back(), file);
    if (auto glimpse = theatre.take_glimpse()) parts_.attendant->keep_picture(std::move(*glimpse), glimpsed_);
}

}  // namespace quadrat::kiosk
