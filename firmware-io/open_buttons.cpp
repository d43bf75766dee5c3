// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "firmware-io/evdev/evdev_buttons.hpp"
#include "firmware-io/evdev/libevdev_host.hpp"
#include "firmware-io/gpio/libgpiod.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/keyboard/keyboard_buttons.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"
#include "firmware-io/text.hpp"

namespace quadrat::firmware_io {
namespace {

std::vector<hid::HidMapping> mappings_in(const std::string& file, std::string& trouble) {
    if (file.empty()) return {};
    try {
        return hid::read_mappings(file);
    } catch (const std::invalid_argument& error) {
        trouble = error.what();
        return {};
    }
}

evdev::Bindings bindings_in(const std::vector<NamedControl>& controls, std::string& trouble) {
    evdev::Bindings bindings;
    for (const NamedControl& named : controls) {
        const auto signal = evdev::signal_named(named.control);
        if (!signal) {
            trouble = "no kernel knows the control " + firmware_io::quoted(named.control) +
                      "; write its name as evtest shows it, such as BTN_SOUTH, KEY_A or ABS_Z+";
            return {};
        }
        bindings.push_back({*signal, named.button});
    }
    return bindings;
}

struct Open {
    std::string& trouble;
    const std::shared_ptr<HeardBoards>& boards;

    std::unique_ptr<ButtonSource> operator()(const KeyboardSpec&) const {
        return std::make_unique<keyboard::KeyboardButtons>();
    }
    std::unique_ptr<ButtonSource> operator()(const ScriptSpec& spec) const {
        return std::make_unique<scripted::ScriptedButtons>(scripted::read_script(spec.file));
    }
    std::unique_ptr<ButtonSource> operator()(const HidSpec& spec) const {
        return std::make_unique<hid::HidButtons>(std::make_unique<hid::Hidraw>(), spec.selector, spec.debounce,
                                                 mappings_in(spec.mappings_file, trouble), boards);
    }
    std::unique_ptr<ButtonSource> operator()(const EvdevSpec& spec) const {
        evdev::EvdevOptions options{spec.selector, spec.debounce, spec.grabs ? evdev::Grab::Yes : evdev::Grab::No,
                                    bindings_in(spec.controls, trouble)};
        return std::make_unique<evdev::EvdevButtons>(std::make_unique<evdev::LibevdevHost>(), std::move(options),
                                                     boards);
    }
    std::unique_ptr<ButtonSource> operator()(const gpio::Wiring& wiring) const {
        return std::make_unique<gpio::GpioButtons>(gpio::open_libgpiod(), wiring);
    }
};

}  // namespace

Opened open_buttons(std::string_view spec) { return open_buttons_beside(spec, nullptr); }

Opened open_buttons_beside(std::string_view spec, const std::shared_ptr<HeardBoards>& boards) {
    Opened opened;
    opened.source = std::visit(Open{opened.map_trouble, boards}, parse_input_spec(spec));
    return opened;
}

}  // namespace quadrat::firmware_io
