// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/bindings.hpp"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <array>

namespace quadrat::firmware_io::evdev {
namespace {

constexpr std::array kKeyConventions{
    Binding{{SignalPart::Key, KEY_A}, Button::A},
    Binding{{SignalPart::Key, KEY_B}, Button::B},
    Binding{{SignalPart::Key, KEY_C}, Button::C},
    Binding{{SignalPart::Key, KEY_D}, Button::D},
    Binding{{SignalPart::Key, KEY_1}, Button::A},
    Binding{{SignalPart::Key, KEY_2}, Button::B},
    Binding{{SignalPart::Key, KEY_3}, Button::C},
    Binding{{SignalPart::Key, KEY_4}, Button::D},
    Binding{{SignalPart::Key, KEY_KP1}, Button::A},
    Binding{{SignalPart::Key, KEY_KP2}, Button::B},
    Binding{{SignalPart::Key, KEY_KP3}, Button::C},
    Binding{{SignalPart::Key, KEY_KP4}, Button::D},
    Binding{{SignalPart::Key, KEY_LEFTCTRL}, Button::A},  // MAME's
    Binding{{SignalPart::Key, KEY_LEFTALT}, Button::B},
    Binding{{SignalPart::Key, KEY_SPACE}, Button::C},
    Binding{{SignalPart::Key, KEY_LEFTSHIFT}, Button::D},
    Binding{{SignalPart::Key, KEY_ESC}, Button::Back},
    Binding{{SignalPart::Key, KEY_BACKSPACE}, Button::Back},
    Binding{{SignalPart::Key, KEY_LEFT}, Button::Back},
    Binding{{SignalPart::Key, KEY_BACK}, Button::Back},
};

constexpr std::array kPadConventions{
    Binding{{SignalPart::Key, BTN_SELECT}, Button::Back},  // "Back" on an X-input pad
    Binding{{SignalPart::Key, BTN_DPAD_UP}, Button::A},   Binding{{SignalPart::Key, BTN_DPAD_RIGHT}, Button::B},
    Binding{{SignalPart::Key, BTN_DPAD_DOWN}, Button::C}, Binding{{SignalPart::Key, BTN_DPAD_LEFT}, Button::D},
    Binding{{SignalPart::Low, ABS_HAT0Y}, Button::A},     Binding{{SignalPart::High, ABS_HAT0X}, Button::B},
    Binding{{SignalPart::High, ABS_HAT0Y}, Button::C},    Binding{{SignalPart::Low, ABS_HAT0X}, Button::D},
};

constexpr std::array kStickConventions{
    Binding{{SignalPart::Low, ABS_Y}, Button::A},
    Binding{{SignalPart::High, ABS_X}, Button::B},
    Binding{{SignalPart::High, ABS_Y}, Button::C},
    Binding{{SignalPart::Low, ABS_X}, Button::D},
};

bool has(const std::vector<Code>& codes, Code code) { return std::binary_search(codes.begin(), codes.end(), code); }

bool is_numbered(Code code) {
    const auto is_within = [code](Code first, Code last) { return first <= code && code <= last; };
    return is_within(BTN_0, BTN_9) || is_within(BTN_TRIGGER, BTN_DEAD) || is_within(BTN_SOUTH, BTN_THUMBR) ||
           is_within(BTN_TRIGGER_HAPPY1, BTN_TRIGGER_HAPPY40);
}

std::vector<Code> numbered_buttons(const EvdevDeviceFacts& device) {
    std::vector<Code> buttons;
    std::copy_if(device.keys.begin(), device.keys.end(), std::back_inserter(buttons), is_numbered);
    return buttons;
}

}  // namespace

bool can_send(const EvdevDeviceFacts& device, const Signal& signal) {
    return has(signal.part == SignalPart::Key ? device.keys : device.axes, signal.code);
}

Bindings default_bindings(const EvdevDeviceFacts& device) {
    Bindings bindings;
    const std::vector<Code> buttons = numbered_buttons(device);
    const auto add = [&](const auto& conventions) {
        for (const Binding& binding : conventions)
            if (can_send(device, binding.signal)) bindings.push_back(binding);
    };
    for (std::size_t i = 0; i < std::min(buttons.size(), kButtons.size()); ++i)
        bindings.push_back({{SignalPart::Key, buttons[i]}, kButtons[i]});
    if (!buttons.empty() || has(device.keys, BTN_DPAD_UP)) add(kPadConventions);
    if (has(device.keys, BTN_SOUTH)) add(kStickConventions);
    add(kKeyConventions);
    return bindings;
}

bool is_pointing(const EvdevDeviceFacts& device) {
    return has(device.keys, BTN_TOUCH) || has(device.keys, BTN_TOOL_PEN) || has(device.keys, BTN_STYLUS) ||
           has(device.keys, BTN_LEFT);
}

int likelihood(const EvdevDeviceFacts& device) {
    if (default_bindings(device).empty()) return 0;
    if (is_pointing(device)) return 1;
    if (!numbered_buttons(device).empty() || has(device.keys, BTN_DPAD_UP)) return 3;
    // A power button, a lid, the volume keys of a headset have a few keys each; the site names those it means.
    return has(device.keys, KEY_A) || has(device.keys, KEY_1) || has(device.keys, KEY_KP1) ||
                   has(device.keys, KEY_LEFTCTRL)
               ? 2
               : 1;
}

}  // namespace quadrat::firmware_io::evdev
