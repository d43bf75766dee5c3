// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"
#include "exhibit/visit.hpp"
#include "firmware-io/lamps.hpp"
#include "kiosk/show.hpp"
#include "stage/theatre.hpp"

// What goes in and out of the visit, in the words of those who hear and show it.
namespace quadrat::kiosk {

exhibit::Choice choice_of(firmware_io::Button button);

// As the keyboard's buttons read it; 0: a key that is no button.
char key_of(display::Key key);

// What lights up is what can be pressed now.
firmware_io::Lamps lamps_for(const Show& show);

stage::Moment moment_of(Show& show, std::optional<stage::Scanned> scanned, base::Instant now);

}  // namespace quadrat::kiosk
