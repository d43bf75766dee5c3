// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/button_press.hpp"
#include "firmware-io/hid/hid_layout.hpp"

namespace quadrat::firmware_io::hid {

// Which signal of a device closes the contact of which of our buttons. Several signals may close the same.
struct Binding {
    HidSignal signal;
    Button button;
    friend bool operator==(const Binding&, const Binding&) = default;
};
using Bindings = std::vector<Binding>;

// What most devices mean, for a device nobody has taught us: in each top-level collection the first five buttons are
// A, B, C, D and Back; a hat or directional pad is A upward and on clockwise; keys A to D, 1 to 4, and those that
// arcade encoders send for the first player's four buttons (left Ctrl, left Alt, Space, left Shift: MAME's layout);
// Escape, Backspace, the left arrow and a media Back key are Back. Axes stay free: an unused one rests anywhere.
// Empty for a device that has none of these.
Bindings default_bindings(const HidLayout& layout);

// How likely it is that a visitor's buttons are on this device: joysticks and gamepads before keyboards before mice and
// the rest. Higher is likelier; 0 if nothing on it can be pressed.
int likelihood(const HidLayout& layout);

}  // namespace quadrat::firmware_io::hid
