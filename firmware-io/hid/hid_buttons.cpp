// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/hid_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/hid/hid_interface.hpp"
#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::hid {
namespace {

constexpr int kTaught = 100;      // likelier than any that was not
constexpr int kTaughtHere = 101;  // and likelier still than its equal in another port

}  // namespace

HidButtons::HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce,
                       std::vector<HidMapping> mappings, std::shared_ptr<HeardBoards> boards)
    : DeviceSource{{"HID device", "plug it in (a gamepad in X-input mode is heard by evdev:)",
                    "give the user read and write access"},
                   std::move(selector)},
      host_{std::move(host)},
      debounce_{debounce},
      mappings_{std::move(mappings)},
      boards_{std::move(boards)} {}

HidButtons::~HidButtons() = default;

std::optional<FoundDevice> HidButtons::candidate(HidDeviceFacts device) const {
    HidLayout layout = parse_descriptor(device.descriptor);
    const HidMapping* mapping = mapping_of(mappings_, device.identity);
    Bindings bindings = mapping != nullptr ? mapping->bindings : Bindings{};
    std::erase_if(bindings, [&](const Binding& binding) { return !can_send(layout, binding.signal); });
    const bool is_here = mapping != nullptr && mapping->port == one_word(device.identity.port) &&
                         mapping->serial == one_word(device.identity.serial);
    const bool is_taught = !bindings.empty();
    FoundDevice found{device.path, device.identity, is_taught ? (is_here ? kTaughtHere : kTaught) : likelihood(layout)};
    if (!is_taught) bindings = default_bindings(layout);
    if (bindings.empty()) return std::nullopt;
    found.is_taught = is_taught;
    const auto& roles = layout.applications;
    found.is_pointing = found.likelihood == 1 && std::find(roles.begin(), roles.end(), kMouse) != roles.end();
    found.open = [this, device = std::move(device), layout = std::move(layout), bindings = std::move(bindings)](
                     Instant now, std::string& trouble) -> std::unique_ptr<HeardDevice> {
        auto stream = host_->open(device.path, trouble);
        if (!stream) return nullptr;
        return std::make_unique<HidInterface>(HidInterface::Opened{device, std::move(stream), layout, bindings, now},
                                              debounce_, boards_);
    };
    return found;
}

std::vector<FoundDevice> HidButtons::find() const {
    std::vector<FoundDevice> found;
    for (HidDeviceFacts& device : those_meant(selector(), host_->devices()))
        if (auto one = candidate(std::move(device))) found.push_back(std::move(*one));
    return found;
}

}  // namespace quadrat::firmware_io::hid
