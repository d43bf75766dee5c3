// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"
#include "kiosk/show.hpp"
#include "machine/start_report.hpp"

namespace quadrat::kiosk {

// Tells the log and systemd how the run is: when the first landscapes were there, when the screen fails and shows
// again.
class Announcer {
  public:
    // Before a frame, once the one before it is drawn.
    void drawn() { start_.drawn(had_landscapes_); }
    // After a frame was handed over.
    void presented(const display::Presented& presented, Show& show);

  private:
    void tell_service(Show& show);

    machine::StartReport start_;
    display::Outcome last_outcome_ = display::Outcome::Shown;
    bool had_landscapes_ = false;  // the last frame
    bool is_ready_ = false;
    float progress_ = -1;
};

}  // namespace quadrat::kiosk
