// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/input_spec.hpp"

#include <algorithm>
#include <stdexcept>

#include "firmware-io/text.hpp"

namespace quadrat::firmware_io {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument{why}; }

struct Setting {
    std::string_view key, value;
};

Setting setting_of(std::string_view part, std::string_view example) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == part.size())
        refuse(quoted(part) + " is not NAME=VALUE; write " + std::string{example});
    return {part.substr(0, equals), part.substr(equals + 1)};
}

bool set_debounce(const Setting& setting, DebounceOptions& debounce) {
    if (setting.key == "debounce") {
        const auto period = parse_duration(setting.value);
        if (!period || *period > std::chrono::seconds{1})
            refuse("debounce is " + quoted(setting.value) + "; write 0ms to 1s, such as 5ms");
        debounce.period = *period;
    } else if (setting.key == "form") {
        if (setting.value != "first-edge" && setting.value != "integrator")
            refuse("form is " + quoted(setting.value) + "; write first-edge or integrator");
        debounce.form = setting.value == "integrator" ? DebounceForm::Integrator : DebounceForm::FirstEdge;
    } else {
        return false;
    }
    return true;
}

// A chip and the number of one of its lines, or a line's name; names with a colon and digits at their end are looked
// for as names first.
gpio::LineAddress line_of(std::string_view text) {
    const std::size_t colon = text.rfind(':');
    const auto offset = colon == std::string_view::npos ? std::nullopt : parse_unsigned(text.substr(colon + 1));
    if (offset && colon > 0) return {"", {std::string{text.substr(0, colon)}, *offset}};
    if (text.starts_with('/')) refuse(quoted(text) + " names no line of the chip; write /dev/gpiochip0:17");
    return {std::string{text}, {}};
}

bool set_inputs(const Setting& setting, gpio::InputOptions& inputs) {
    if (setting.key == "pull") {
        if (setting.value == "up")
            inputs.pull = gpio::Pull::Up;
        else if (setting.value == "down")
            inputs.pull = gpio::Pull::Down;
        else if (setting.value == "none")
            inputs.pull = gpio::Pull::None;
        else
            refuse("pull is " + quoted(setting.value) + "; write up, down or none");
    } else if (setting.key == "active") {
        if (setting.value == "low")
            inputs.active = gpio::Active::Low;
        else if (setting.value == "high")
            inputs.active = gpio::Active::High;
        else
            refuse("active is " + quoted(setting.value) + "; write low or high");
    } else {
        return false;
    }
    return true;
}

void add_wire(const Setting& setting, gpio::Wiring& wiring) {
    const bool is_lamp = setting.key.starts_with("lamp");
    const auto button = button_named(is_lamp ? setting.key.substr(4) : setting.key);
    if (!button)
        refuse(quoted(setting.key) +
               " is not a setting; write A, B, C, D, Back, lampA to lampBack, pull, active, debounce or form");
    const gpio::Wire wire{*button, line_of(setting.value)};
    for (const auto* wires : {&wiring.contacts, &wiring.lamps})
        for (const gpio::Wire& other : *wires)
            if (other.line == wire.line) refuse("line " + to_string(wire.line) + " is named twice; give each its own");
    (is_lamp ? wiring.lamps : wiring.contacts).push_back(wire);
}

gpio::Wiring parse_gpio(std::string_view text) {
    constexpr std::string_view kExample = "gpio:A=GPIO17,B=GPIO27,C=GPIO22,D=GPIO23,Back=GPIO24";
    gpio::Wiring wiring;
    for (const std::string_view part : split(text, ',')) {
        const Setting setting = setting_of(trimmed(part), kExample);
        if (!set_debounce(setting, wiring.debounce) && !set_inputs(setting, wiring.inputs)) add_wire(setting, wiring);
    }
    if (wiring.contacts.empty()) refuse("no button has a line; write " + std::string{kExample});
    return wiring;
}

void parse_vendor_product(std::string_view part, std::string_view kind, DeviceSelector& selector) {
    const auto numbers = split(part, ':');
    const auto number = [&](std::size_t i) -> std::optional<std::uint16_t> {
        const auto value =
            numbers.size() == 2 && numbers[i].size() <= 4 ? parse_unsigned(numbers[i], 16) : std::nullopt;
        return value ? std::optional{static_cast<std::uint16_t>(*value)} : std::nullopt;
    };
    selector.vendor = number(0);
    selector.product = number(1);
    if (!selector.vendor || !selector.product)
        refuse(quoted(part) + " is not VENDOR:PRODUCT in hexadecimal; write " + std::string{kind} +
               ":0079:0006 (lsusb shows them)");
}

bool set_selector(const Setting& setting, DeviceSelector& selector) {
    if (setting.key == "path")
        selector.path = setting.value;
    else if (setting.key == "port")
        selector.port = setting.value;
    else if (setting.key == "serial")
        selector.serial = setting.value;
    else if (setting.key == "name")
        selector.name = setting.value;
    else
        return false;
    return true;
}

// What hid: and evdev: share: VENDOR:PRODUCT first, if it is given, and settings. Those that are not shared go to
// `other`.
template <typename Other>
void parse_device(std::string_view text, std::string_view kind, DeviceSelector& selector, Other other) {
    const auto parts = split(text, ',');
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string_view part = trimmed(parts[i]);
        if (i == 0 && part.empty()) continue;
        if (i == 0 && part.find('=') == std::string_view::npos) {
            parse_vendor_product(part, kind, selector);
            continue;
        }
        const Setting setting = setting_of(part, std::string{kind} + ":0079:0006,port=usb-0000:00:14.0-1.2");
        if (!set_selector(setting, selector)) other(setting);
    }
}

HidSpec parse_hid(std::string_view text) {
    HidSpec spec;
    parse_device(text, "hid", spec.selector, [&](const Setting& setting) {
        if (setting.key == "map")
            spec.mappings_file = setting.value;
        else if (!set_debounce(setting, spec.debounce))
            refuse(quoted(setting.key) + " is not a setting; write path, port, serial, name, map, debounce or form");
    });
    return spec;
}

// Which of them a kernel knows is found out when the source is opened; here, that it can be one.
bool is_control(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
    const bool is_axis = name.starts_with("ABS_");
    if (is_axis && !name.ends_with('+') && !name.ends_with('-')) return false;
    if (is_axis) name.remove_suffix(1);
    return (is_axis || name.starts_with("BTN_") || name.starts_with("KEY_")) && name.size() > 4 &&
           std::all_of(name.begin(), name.end(), is_letter);
}

void add_control(const Setting& setting, EvdevSpec& spec) {
    const auto button = button_named(setting.key);
    if (!button)
        refuse(quoted(setting.key) +
               " is not a setting; write A, B, C, D, Back, path, port, serial, name, grab, debounce or form");
    if (!is_control(setting.value))
        refuse(quoted(setting.value) +
               " is not a control; write its name as evtest shows it: BTN_SOUTH, KEY_A, or an " +
               "end of an axis, ABS_Z+ or ABS_HAT0X-");
    spec.controls.push_back({*button, std::string{setting.value}});
}

EvdevSpec parse_evdev(std::string_view text) {
    EvdevSpec spec;
    parse_device(text, "evdev", spec.selector, [&](const Setting& setting) {
        if (setting.key == "grab") {
            if (setting.value != "yes" && setting.value != "no")
                refuse("grab is " + quoted(setting.value) + "; write yes or no");
            spec.grabs = setting.value == "yes";
        } else if (!set_debounce(setting, spec.debounce)) {
            add_control(setting, spec);
        }
    });
    return spec;
}

InputSpec parse(std::string_view spec) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; };
    if (std::any_of(spec.begin(), spec.end(), is_control)) refuse("it has control characters; write it on one line");
    const std::size_t colon = spec.find(':');
    const std::string_view kind = spec.substr(0, colon);
    const std::string_view rest = colon == std::string_view::npos ? std::string_view{} : spec.substr(colon + 1);
    if (spec == "keyboard") return KeyboardSpec{};
    if (colon != std::string_view::npos && kind == "gpio") return parse_gpio(rest);
    if (colon != std::string_view::npos && kind == "hid") return parse_hid(rest);
    if (colon != std::string_view::npos && kind == "evdev") return parse_evdev(rest);
    if (colon != std::string_view::npos && kind == "script") {
        if (rest.empty()) refuse("no file is named; write script:FILE");
        return ScriptSpec{std::string{rest}};
    }
    refuse("no such input; write keyboard, script:FILE, hid:, hid:VENDOR:PRODUCT, evdev: or gpio:A=GPIO17,…");
}

}  // namespace

InputSpec parse_input_spec(std::string_view spec) {
    try {
        return parse(spec);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument{"input " + quoted(spec) + ": " + error.what()};
    }
}

}  // namespace quadrat::firmware_io
