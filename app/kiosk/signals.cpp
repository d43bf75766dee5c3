// SPDX-License-Identifier: Apache-2.0
#include "kiosk/signals.hpp"

#include <utility>

#include "firmware-io/keyboard/keyboard_buttons.hpp"

namespace quadrat::kiosk {

using exhibit::Screen;
using firmware_io::Button;
using firmware_io::LampPattern;

exhibit::Choice choice_of(Button button) {
    using exhibit::Choice;
    switch (button) {
        case Button::A:
            return Choice::A;
        case Button::B:
            return Choice::B;
        case Button::C:
            return Choice::C;
        case Button::D:
            return Choice::D;
        case Button::Back:
            break;
    }
    return Choice::Back;
}

char key_of(display::Key key) {
    switch (key) {
        case display::Key::A:
        case display::Key::One:
            return 'A';
        case display::Key::B:
        case display::Key::Two:
            return 'B';
        case display::Key::C:
        case display::Key::Three:
            return 'C';
        case display::Key::D:
        case display::Key::Four:
            return 'D';
        case display::Key::Backspace:
        case display::Key::Left:
            return firmware_io::keyboard::kBackspace;
        default:
            return 0;
    }
}

firmware_io::Lamps lamps_for(const Show& show) {
    const bool asks = exhibit::asks(show.state());
    const bool invites = show.state().screen == Screen::Attract || show.state().screen == Screen::StillThere;
    firmware_io::Lamps lamps;
    lamps.fill(asks ? LampPattern::Steady : invites ? LampPattern::Breathing : LampPattern::Off);
    lamps[firmware_io::index_of(Button::Back)] = show.can_go_back() ? LampPattern::Steady : LampPattern::Off;
    if (show.state().screen == exhibit::Screen::StillThere) lamps.fill(LampPattern::Blinking);
    return lamps;
}

stage::Moment moment_of(Show& show, std::optional<stage::Scanned> scanned, base::Instant now) {
    stage::Moment moment{show.state(), show.timings(), show.on_stage(), show.last_press(), show.asked()};
    moment.scanned = std::move(scanned);
    moment.growing_progress = show.programme().progress();
    moment.caption = show.caption();
    moment.take_home = show.take_home();
    moment.language = show.shown_language(now);
    moment.now = now;
    return moment;
}

}  // namespace quadrat::kiosk
