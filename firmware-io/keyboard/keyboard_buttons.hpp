// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/button_source.hpp"
#include "firmware-io/debounce.hpp"

namespace quadrat::firmware_io::keyboard {

// The keys that are not letters or digits, as ASCII has them; the arrow took a free code.
inline constexpr char kEscape = 27;
inline constexpr char kBackspace = 8;
inline constexpr char kArrowLeft = 1;

// A B C D or 1 2 3 4, in either case; Back is Escape, Backspace or the arrow to the left. Other keys: none.
std::optional<Button> button_for_key(char key);

// The keys of a window. Whoever owns the window calls key() with what it reports; repeats of a held key are ignored,
// and two keys of one button are one contact.
class KeyboardButtons final : public ButtonSource {
  public:
    explicit KeyboardButtons(DebounceOptions debounce = {}) : debouncer_{debounce} {}

    void key(char key, Motion motion, Instant at) override;

    // The window lost the keyboard: keys that are down will not be reported going up.
    void lost_focus(Instant at);

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return {}; }
    const Contacts& contacts() const override { return debouncer_.contacts(); }
    std::optional<Instant> next_event_at() const override;

  private:
    struct Stroke {
        char key;
        Motion motion;
        Instant at;
        bool is_focus_lost;
    };
    void play(const Stroke& stroke);

    Debouncer debouncer_;
    std::vector<Stroke> strokes_;  // not yet due
    std::array<bool, 128> is_held_{};
};

}  // namespace quadrat::firmware_io::keyboard
