// SPDX-License-Identifier: Apache-2.0
// The room `firmware-io`: buttons and lamps. GPIO, HID, evdev, keyboard and scripts, each a ButtonSource; debounce and
// merge. Nothing here knows what a press means, and it includes no room of ours: other programs may use it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware-io/button_press.hpp"
#include "firmware-io/lamps.hpp"

namespace quadrat::firmware_io {

enum class Presence { Present, Absent };

// Whether the hardware is there. `reason` is one line: when absent what is missing and the remedy, otherwise what is
// in use ("" where there is nothing to say). A source changes it only when something happened, so whoever logs each
// change says everything once.
struct SourceStatus {
    Presence presence = Presence::Present;
    std::string reason;
    friend bool operator==(const SourceStatus&, const SourceStatus&) = default;
};

// What is known of one contact besides its edges, so that a stuck or chattering button can be recognised.
struct Contact {
    bool is_down = false;         // after debouncing: a Down was delivered and its Up was not
    Instant down_since{0};        // of that Down; meaningless while up
    bool is_closed = false;       // as the hardware last said, before debouncing
    Instant closed_since{0};      // of the last closing; meaningless while open
    std::uint64_t raw_edges = 0;  // closings and openings seen before debouncing, ever
};
using Contacts = std::array<Contact, kButtons.size()>;  // in the order of kButtons

inline constexpr std::size_t index_of(Button button) { return static_cast<std::size_t>(button); }

// A place where presses come from. No call blocks; poll() is cheap enough for every frame. One thread at a time.
//
// Promised by every source: one press is one Down and later one Up; a held button does not repeat; contact bounce never
// doubles a press; edges come in the order of their time, none before its time and none later than `now`; a device that
// vanishes gives an Up for what it held down, and one that comes back with a button held gives no Down until that
// button has been released. Missing hardware is not an error: the source is Absent and tries again by itself,
// every second of the `now` it is given.
class ButtonSource {
  public:
    virtual ~ButtonSource() = default;

    // The edges since the last call, up to and including `now`. `now` does not go backwards.
    virtual std::vector<ButtonEdge> poll(Instant now) = 0;

    virtual SourceStatus status() const = 0;
    // Whether the hardware is there and could be had, by looking alone: nothing is taken from whoever uses it, and what
    // a running exhibit has taken is as good as free.
    virtual SourceStatus look() { return status(); }
    virtual const Contacts& contacts() const = 0;

    // At once, as far as the moment of the last poll tells how far a breath has gone. A source without lamps ignores
    // it.
    virtual void set_lamps(const Lamps&) {}

    // A key of a window, for the source that listens to a keyboard; the others ignore it. Letters are upper case, the
    // remaining keys are named in keyboard/keyboard_buttons.hpp.
    virtual void key(char /*key*/, Motion, Instant /*at*/) {}

    // When the next edge is due if nothing else happens, so that a simulated clock can jump there.
    virtual std::optional<Instant> next_event_at() const { return std::nullopt; }

    // Whether a script has come to its end. Hardware never does.
    virtual bool is_finished() const { return false; }
};

}  // namespace quadrat::firmware_io
