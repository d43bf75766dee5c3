// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string_view>
#include <variant>

#include "firmware-io/button_source.hpp"
#include "firmware-io/gpio/gpio_buttons.hpp"
#include "firmware-io/heard_boards.hpp"
#include "firmware-io/hid/hid_buttons.hpp"

namespace quadrat::firmware_io {

struct KeyboardSpec {};
struct ScriptSpec {
    std::string file;
};
struct HidSpec {
    hid::HidSelector selector;
    DebounceOptions debounce;
    std::string mappings_file;  // "" for none
};
struct NamedControl {
    Button button;
    std::string control;  // "BTN_SOUTH", "KEY_A", "ABS_Z+"
    friend bool operator==(const NamedControl&, const NamedControl&) = default;
};
struct EvdevSpec {
    DeviceSelector selector;
    DebounceOptions debounce;
    bool grabs = true;
    std::vector<NamedControl> controls;  // in place of the usual ones
};
using InputSpec = std::variant<KeyboardSpec, ScriptSpec, HidSpec, gpio::Wiring, EvdevSpec>;

// Where presses come from, as --input names it:
//   keyboard
//   script:FILE
//   hid:                                  the likeliest device
//   hid:0079:0006  hid:path=/dev/hidraw3  hid:port=usb-0000:00:14.0-1.2
//   evdev:   evdev:045e:028e   evdev:path=/dev/input/event3   evdev:A=BTN_SOUTH,B=KEY_SPACE,C=ABS_Z+
//   gpio:A=GPIO17,B=GPIO27,C=/dev/gpiochip0:22,lampA=GPIO5     with pull=up|down|none, active=low|high
// hid and evdev take also name=PART, serial=…, port=…; hid takes map=FILE, what was learned about the site's devices
// (hid/mapping.hpp), evdev grab=yes|no. A chip of gpio is its path, a link to it, its label or its number. All three
// take debounce=5ms and form=first-edge|integrator; parts are separated by commas. Pure, for any bytes. Throws
// std::invalid_argument, one line: the spec, what is wrong and what would be right.
InputSpec parse_input_spec(std::string_view spec);

// The source itself. Missing hardware is no error here (see ButtonSource), nor is a map of HID devices that cannot be
// read or is damaged, nor a control that no kernel knows: the usual bindings apply. An unreadable script is one. Throws
// std::invalid_argument as above.
struct Opened {
    std::unique_ptr<ButtonSource> source;
    std::string map_trouble;  // what is wrong with the map and mends it; "" when it is used or none is named
};
Opened open_buttons(std::string_view spec);

// The same for one of several inputs of an exhibit, which share `boards`: one press on a board that both hid: and
// evdev: mean is heard once, by hid:.
Opened open_buttons_beside(std::string_view spec, const std::shared_ptr<HeardBoards>& boards);

}  // namespace quadrat::firmware_io
