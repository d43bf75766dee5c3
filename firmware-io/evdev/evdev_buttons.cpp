// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/evdev_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/evdev/evdev_device.hpp"

namespace quadrat::firmware_io::evdev {

EvdevButtons::EvdevButtons(std::unique_ptr<EvdevHost> host, EvdevOptions options,
                           std::shared_ptr<const HeardBoards> boards)
    : DeviceSource{{"input device", "plug it in", "stop the program that has it"}, options.selector},
      host_{std::move(host)},
      options_{std::move(options)},
      boards_{std::move(boards)} {}

std::optional<FoundDevice> EvdevButtons::candidate(EvdevDeviceFacts device) const {
    constexpr int kNamed = 3;  // as likely as what the bindings were given for
    Bindings bindings = options_.bindings;
    std::erase_if(bindings, [&](const Binding& binding) { return !can_send(device, binding.signal); });
    const bool is_usual = options_.bindings.empty();
    FoundDevice found{device.path, device.identity, is_usual ? likelihood(device) : bindings.empty() ? 0 : kNamed};
    if (found.likelihood == 0) return std::nullopt;
    if (is_usual) bindings = default_bindings(device);
    found.may_be_first = found.likelihood > 1 || selector() != DeviceSelector{};
    found.is_pointing = is_pointing(device);
    found.open = [this, device = std::move(device), bindings = std::move(bindings)](
                     Instant now, std::string& trouble) -> std::unique_ptr<HeardDevice> {
        auto stream = host_->open(device.path, options_.grab, trouble);
        if (!stream) return nullptr;
        return std::make_unique<EvdevDevice>(EvdevDevice::Opened{device, std::move(stream), bindings, now},
                                             options_.debounce);
    };
    return found;
}

std::vector<FoundDevice> EvdevButtons::find() const {
    std::vector<FoundDevice> found;
    for (EvdevDeviceFacts& device : those_meant(options_.selector, host_->devices()))
        if (auto one = candidate(std::move(device))) found.push_back(std::move(*one));
    return found;
}

}  // namespace quadrat::firmware_io::evdev
