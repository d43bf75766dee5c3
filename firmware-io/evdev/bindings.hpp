// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/evdev/evdev_host.hpp"

namespace quadrat::firmware_io::evdev {

// Something a person can press: a key, or one end of an axis.
enum class SignalPart : std::uint8_t { Key, Low, High };
struct Signal {
    SignalPart part = SignalPart::Key;
    Code code = 0;
    friend auto operator<=>(const Signal&, const Signal&) = default;
};

struct Binding {
    Signal signal;
    Button button;
    friend bool operator==(const Binding&, const Binding&) = default;
};
using Bindings = std::vector<Binding>;

bool can_send(const EvdevDeviceFacts& device, const Signal& signal);

// What most devices mean, as hid: has it: the first five of a pad's numbered buttons are A, B, C, D and Back; a hat, a
// directional pad and the left stick of an X-input pad are A upward and on clockwise; keys A to D, 1 to 4, and those of
// MAME's layout; Escape, Backspace, the left arrow, and a pad's or remote control's Select and Back are Back. Triggers,
// other sticks, and the axes of other devices stay free: an unused one rests anywhere. Empty for a device without
// these.
Bindings default_bindings(const EvdevDeviceFacts& device);

// A mouse, a touchpad, a tablet: not heard beside a board's other interfaces.
bool is_pointing(const EvdevDeviceFacts& device);

// How likely it is that a visitor's buttons are on this device: pads and button boards before keyboards before the
// rest. Higher is likelier; 0 if nothing on it can be pressed.
int likelihood(const EvdevDeviceFacts& device);

}  // namespace quadrat::firmware_io::evdev
