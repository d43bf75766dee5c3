// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"
#include "kiosk/show.hpp"
#include "machine/start_report.hpp"
#include "tempo/tempo.hpp"

namespace quadrat::kiosk {

// Tells the log and systemd how the run is: when the first landscapes were there, when the screen fails and shows
// again.
class Announcer {
  public:
    // Before a frame, once the one before it is drawn.
    void drawn() { start_.drawn(had_landscapes_); }
    // After a frame was handed over.
    void presented(const display::Presented& presented, Show& show);
    // The governor's, with its reason, which is remembered for the next start.
    void decided(const tempo::Tempo& tempo, const std::string& gpu, Show& show, base::Instant now);

  private:
    void tell_service(Show& show);

    machine::StartReport start_;
    display::Outcome last_outcome_ = display::Outcome::Shown;
    bool had_landscapes_ = false;  // the last frame
    bool is_ready_ = false;
    float progress_ = -1;
    std::optional<base::Instant> remembered_at_;  // the last decision that was
};

}  // namespace quadrat::kiosk
