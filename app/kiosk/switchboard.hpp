// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "firmware-io/button_press.hpp"
#include "firmware-io/lamps.hpp"
#include "kiosk/show.hpp"
#include "site/configuration.hpp"
#include "stage/scanned.hpp"
#include "switches/switches.hpp"

namespace quadrat::kiosk {

switches::Options switch_options_of(const site::Configuration& configuration);

// Between the panel and the show: passes each press of four buttons on unchanged, and makes of one button or two, by
// the room `switches`, what the visit knows.
class Switchboard {
  public:
    // Both are borrowed.
    Switchboard(const site::Configuration& configuration, Show& show) : configuration_(configuration), show_(show) {}

    // A press or a release of the visit's.
    void take_edge(const firmware_io::ButtonEdge& edge, base::Instant now);
    // An edge was meant for staff: what they hold is held no longer here.
    void let_go(base::Instant now);
    // Once a frame, after the edges.
    void look(base::Instant now);

    std::optional<base::Instant> next_deadline() const;
    // What is marked waits until then.
    void wait_for_speech(base::Instant until) { speaks_until_ = until; }
    bool has_four_buttons() const { return state_.buttons == switches::Buttons::Four; }
    // What the narrator tells of, with what is marked.
    hearing::Subject heard(base::Instant now) const;
    // What lights up is what can be pressed now, or is marked.
    firmware_io::Lamps lamps() const;
    // How it is shown; nothing while four buttons are played with and none is held.
    std::optional<stage::Scanned> scanned(base::Instant now) const;

  private:
    void take(const switches::Step& step, base::Instant now);
    switches::Beside beside() const {
        return {show_.state(), show_.can_go_back(), speaks_until_, exhibit::meant_by(show_.state(), show_.timings())};
    }
    std::string hint(const switches::Options& options) const;

    const site::Configuration& configuration_;
    Show& show_;
    switches::State state_;
    base::Instant speaks_until_{0};
};

}  // namespace quadrat::kiosk
