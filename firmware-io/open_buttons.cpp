// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "firmware-io/gpio/libgpiod.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/keyboard/keyboard_buttons.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"

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

struct Open {
    std::string& trouble;

    std::unique_ptr<ButtonSource> operator()(const KeyboardSpec&) const {
        return std::make_unique<keyboard::KeyboardButtons>();
    }
    std::unique_ptr<ButtonSource> operator()(const ScriptSpec& spec) const {
        return std::make_unique<scripted::ScriptedButtons>(scripted::read_script(spec.file));
    }
    std::unique_ptr<ButtonSource> operator()(const HidSpec& spec) const {
        return std::make_unique<hid::HidButtons>(std::make_unique<hid::Hidraw>(), spec.selector, spec.debounce,
                                                 mappings_in(spec.mappings_file, trouble));
    }
    std::unique_ptr<ButtonSource> operator()(const gpio::Wiring& wiring) const {
        return std::make_unique<gpio::GpioButtons>(gpio::open_libgpiod(), wiring);
    }
};

}  // namespace

Opened open_buttons(std::string_view spec) {
    Opened opened;
    opened.source = std::visit(Open{opened.map_trouble}, parse_input_spec(spec));
    return opened;
}

}  // namespace quadrat::firmware_io
