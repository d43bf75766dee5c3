// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/gpio/libgpiod.hpp"
#include "firmware-io/hid/hidraw.hpp"
#include "firmware-io/input_spec.hpp"
#include "firmware-io/keyboard/keyboard_buttons.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"

namespace quadrat::firmware_io {
namespace {

struct Open {
    std::unique_ptr<ButtonSource> operator()(const KeyboardSpec&) const {
        return std::make_unique<keyboard::KeyboardButtons>();
    }
    std::unique_ptr<ButtonSource> operator()(const ScriptSpec& spec) const {
        return std::make_unique<scripted::ScriptedButtons>(scripted::read_script(spec.file));
    }
    std::unique_ptr<ButtonSource> operator()(const HidSpec& spec) const {
        auto mappings =
            spec.mappings_file.empty() ? std::vector<hid::HidMapping>{} : hid::read_mappings(spec.mappings_file);
        return std::make_unique<hid::HidButtons>(std::make_unique<hid::Hidraw>(), spec.selector, spec.debounce,
                                                 std::move(mappings));
    }
    std::unique_ptr<ButtonSource> operator()(const gpio::Wiring& wiring) const {
        return std::make_unique<gpio::GpioButtons>(gpio::open_libgpiod(), wiring);
    }
};

}  // namespace

std::unique_ptr<ButtonSource> open_buttons(std::string_view spec) { return std::visit(Open{}, parse_input_spec(spec)); }

}  // namespace quadrat::firmware_io
