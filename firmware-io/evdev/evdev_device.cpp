// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/evdev_device.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io::evdev {
namespace {

constexpr std::size_t kMostEventsPerPoll = 1024;  // a flood must not keep the frame waiting

}  // namespace

EvdevDevice::EvdevDevice(Opened opened, DebounceOptions debounce)
    : HeardDevice{opened.device.path, opened.device.identity, debounce},
      stream_{std::move(opened.stream)},
      reader_{stream_->at_opening()},
      bindings_{std::move(opened.bindings)} {
    for (const Button button : kButtons) debouncer().found(button, is_closed(button), opened.at);
}

bool EvdevDevice::is_closed(Button button) const {
    return std::any_of(bindings_.begin(), bindings_.end(), [&](const Binding& binding) {
        return binding.button == button && reader_.is_pressed(binding.signal);
    });
}

// All that waits is shown to the clock first: its estimate is best with the event that waited least.
HeardDevice::Plug EvdevDevice::hear(Instant now) {
    std::vector<ControlEvent> events;
    EvdevStream::Took took = EvdevStream::Took::Event;
    for (ControlEvent event; events.size() < kMostEventsPerPoll;) {
        took = stream_->take(event);
        if (took != EvdevStream::Took::Event) break;
        clock_.saw(event.kernel_time, now);
        events.push_back(event);
    }
    for (const ControlEvent& event : events) {
        reader_.take(event);
        if (event.kind != ControlKind::Report) continue;
        for (const Button button : kButtons)
            debouncer().contact(button, is_closed(button), clock_.moment_of(event.kernel_time));
    }
    return took == EvdevStream::Took::Gone ? Plug::Gone : Plug::In;
}

}  // namespace quadrat::firmware_io::evdev
