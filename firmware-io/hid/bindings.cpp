// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/bindings.hpp"

#include <algorithm>
#include <array>

namespace quadrat::firmware_io::hid {
namespace {

struct Convention {
    Usage usage;
    SignalPart part;
    Button button;
};

constexpr Convention key(unsigned id, Button button) {
    return {usage(page::kKeyboard, id), SignalPart::Pressed, button};
}
constexpr Convention pad(unsigned id, Button button) {
    return {usage(page::kDesktop, id), SignalPart::Pressed, button};
}

constexpr std::array kConventions{
    key(0x04, Button::A),
    key(0x05, Button::B),
    key(0x06, Button::C),
    key(0x07, Button::D),  // A B C D
    key(0x1e, Button::A),
    key(0x1f, Button::B),
    key(0x20, Button::C),
    key(0x21, Button::D),  // 1 2 3 4
    key(0x59, Button::A),
    key(0x5a, Button::B),
    key(0x5b, Button::C),
    key(0x5c, Button::D),  // keypad
    key(0xe0, Button::A),
    key(0xe2, Button::B),
    key(0x2c, Button::C),
    key(0xe1, Button::D),  // MAME
    key(0x29, Button::Back),
    key(0x2a, Button::Back),
    key(0x50, Button::Back),  // Esc ⌫ ←
    pad(0x90, Button::A),
    pad(0x92, Button::B),
    pad(0x91, Button::C),
    pad(0x93, Button::D),  // d-pad
    Convention{kHatSwitch, SignalPart::Up, Button::A},
    Convention{kHatSwitch, SignalPart::Right, Button::B},
    Convention{kHatSwitch, SignalPart::Down, Button::C},
    Convention{kHatSwitch, SignalPart::Left, Button::D},
    Convention{usage(page::kConsumer, 0x224), SignalPart::Pressed, Button::Back},  // AC Back
};

// The numbered buttons of a collection, ascending. Arrays of buttons count with the first numbers of their range.
std::vector<Usage> numbered_buttons(const HidLayout& layout, std::uint16_t collection) {
    std::vector<Usage> usages;
    for (const Variable& variable : layout.variables)
        if (variable.collection == collection && page_of(variable.usage) == page::kButton)
            usages.push_back(variable.usage);
    for (const Array& array : layout.arrays)
        for (const UsageRange& range : array.usages)
            if (array.collection == collection && page_of(range.first) == page::kButton)
                for (Usage u = std::max(range.first, usage(page::kButton, array.logical_min == 0 ? 1 : 0));
                     u <= range.last && u - range.first < kButtons.size() + 1; ++u)
                    usages.push_back(u);
    std::sort(usages.begin(), usages.end());
    usages.erase(std::unique(usages.begin(), usages.end()), usages.end());
    return usages;
}

}  // namespace

Bindings default_bindings(const HidLayout& layout) {
    Bindings bindings;
    for (std::size_t c = 0; c < layout.applications.size(); ++c) {
        const auto collection = static_cast<std::uint16_t>(c);
        const std::vector<Usage> buttons = numbered_buttons(layout, collection);
        for (std::size_t i = 0; i < std::min(buttons.size(), kButtons.size()); ++i)
            bindings.push_back({{collection, buttons[i], SignalPart::Pressed}, kButtons[i]});
        for (const Convention& convention : kConventions) {
            const HidSignal signal{collection, convention.usage, convention.part};
            if (can_send(layout, signal)) bindings.push_back({signal, convention.button});
        }
    }
    return bindings;
}

int likelihood(const HidLayout& layout) {
    if (default_bindings(layout).empty()) return 0;
    int best = 1;
    for (const Usage application : layout.applications) {
        if (application == kJoystick || application == kGamepad) best = std::max(best, 3);
        if (application == kKeyboardDevice || application == kKeypadDevice) best = std::max(best, 2);
    }
    return best;
}

}  // namespace quadrat::firmware_io::hid
