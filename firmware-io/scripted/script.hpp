// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "firmware-io/button_press.hpp"

namespace quadrat::firmware_io::scripted {

// What happens to the contacts, before any debouncing. Unplug and Plug concern all of them; their button says nothing.
enum class Happening { Close, Open, Unplug, Plug };
struct ScriptEvent {
    Instant at;
    Happening happening;
    Button button = Button::A;
    friend bool operator==(const ScriptEvent&, const ScriptEvent&) = default;
};

// A visitor as a timeline that starts with the program. Events in order of time; `end` is no earlier than the last.
struct Script {
    std::vector<ScriptEvent> events;
    Instant end{0};
};

inline constexpr std::size_t kMostEvents = 100'000;
inline constexpr Instant kCleanPress = std::chrono::milliseconds{80};  // from closing to opening

struct ScriptError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

// Writes a script in code: each call begins where the one before ended. Throws ScriptError for what no hand can do
// (closing a button that is still held) and beyond kMostEvents.
class ScriptWriter {
  public:
    ScriptWriter& at(Instant moment);  // the next action begins here; not before the last action began
    ScriptWriter& wait(Instant span);
    ScriptWriter& press(Button button) { return hold(button, kCleanPress); }
    ScriptWriter& hold(Button button, Instant span);
    ScriptWriter& hold(Button button);  // until release()
    ScriptWriter& chord(const std::vector<Button>& buttons, Instant span = kCleanPress);
    // `edges` bounces evenly over `span`, the first one a closing; closed from then on for a clean press.
    ScriptWriter& bounce(Button button, std::size_t edges, Instant span);
    ScriptWriter& release(Button button);
    ScriptWriter& release();  // whatever is held; nothing if nothing is
    ScriptWriter& unplug();   // the device vanishes, its buttons still where they are
    ScriptWriter& plug();

    Script script() const;

  private:
    void add(ScriptEvent event);
    void close(Button button, Instant from, Instant until);
    void begin_action();

    std::vector<ScriptEvent> events_;
    std::array<Instant, kButtons.size()> free_from_{};  // Instant::max(): held
    bool is_plugged_ = true;
    Instant cursor_{0};
    Instant last_action_{0};
    Instant end_{0};
};

// A script as text, one action a line; '#' begins a comment.
//
//     at 2.5s press B            # on the clock that starts with the program
//     after 400ms press A        # from the end of the action above
//     press C                    # at its end
//     hold C for 3s              # or "hold C", until "release C" or "release"
//     chord A+B                  # or "chord A+B for 300ms"
//     bounce B 12 edges over 8ms
//     wait 30s
//     unplug                     # and later "plug"
//
// Pure, for any bytes. Throws ScriptError: one line "SOURCE:LINE: what is wrong; what would be right".
Script parse_script(std::string_view text, std::string_view source_name);

}  // namespace quadrat::firmware_io::scripted
