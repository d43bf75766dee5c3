// SPDX-License-Identifier: Apache-2.0
// The room `kiosk`: the bridge. The frame loop, and the show that carries out what the exhibit wishes. What can be said
// without the loop lives in a room below it: this one stays under 2,500 lines (tests/style).
#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "display/display.hpp"
#include "firmware-io/button_source.hpp"
#include "kiosk/show.hpp"
#include "pictures/album.hpp"
#include "staff/attendant.hpp"
#include "staff/keepsakes.hpp"
#include "staff/ladder.hpp"
#include "staff/panel.hpp"
#include "stage/theatre.hpp"
#include "tempo/tempo.hpp"

namespace quadrat::kiosk {

// Whoever measures a run. This one looks away.
class RunWatcher {
  public:
    virtual ~RunWatcher() = default;
    virtual void uploaded_for(std::chrono::nanoseconds) {}  // of each frame, in order
    virtual void decided(base::Instant, const std::string& /*why*/) {}
};

// What a run that is measured leaves behind.
struct RunRecord : RunWatcher {
    struct Decision {
        base::Instant at{0};
        std::string why;
    };
    std::vector<std::chrono::nanoseconds> uploads_took;  // of each frame, in order
    std::vector<Decision> decisions;                     // the governor's

    void uploaded_for(std::chrono::nanoseconds span) override { uploads_took.push_back(span); }
    void decided(base::Instant at, const std::string& why) override { decisions.push_back({at, why}); }
};

// Who is there where nobody else was named, all without a state.
namespace nobody {
inline staff::Attendant attendant;
inline staff::Keepsakes keepsakes;
inline RunWatcher watcher;
inline const std::atomic<bool> stop{false};
}  // namespace nobody

struct RunLoopParts {
    const site::Configuration& configuration;
    base::Clock& clock;
    display::Display& display;
    staff::Panel& panel;
    firmware_io::ButtonSource& buttons;  // the panel's, for what is not a press
    Show& show;
    tempo::Tempo& tempo;
    staff::Attendant* attendant = &nobody::attendant;  // borrowed, as all that follows
    staff::Keepsakes* keepsakes = &nobody::keepsakes;
    staff::Mode mode = staff::Mode::Usual;
    bool calibrates = false;           // this GPU first, when four landscapes are there; tempo starts from that
    pictures::Album* album = nullptr;  // nothing: no pictures are kept
    bool ends_after_visit = false;     // the program ends with the first visit that ends
    const std::atomic<bool>* stop = &nobody::stop;
    base::Seed seed{};  // names all chance in what is heard
    RunWatcher* watcher = &nobody::watcher;
};

enum class RunEnd { Stopped, WindowClosed, VisitOver, ScriptOver, DisplayFault, Restart };

// The frame loop: presses in, frames out, until something ends it. On a simulated clock it goes from one moment at
// which something happens to the next, drawing a frame at each; nothing it does then depends on how fast the machine
// is.
RunEnd run_loop(const RunLoopParts& parts);

}  // namespace quadrat::kiosk
