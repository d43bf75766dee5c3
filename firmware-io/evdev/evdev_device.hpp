// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "firmware-io/evdev/control_reader.hpp"
#include "firmware-io/heard_devices.hpp"
#include "firmware-io/kernel_clock.hpp"

namespace quadrat::firmware_io::evdev {

// One opened event device, and which of its signals close which contact. What is held when it is opened is no press.
class EvdevDevice final : public HeardDevice {
  public:
    struct Opened {
        const EvdevDeviceFacts& device;
        std::unique_ptr<EvdevStream> stream;
        Bindings bindings;
        Instant at;
    };
    EvdevDevice(Opened opened, DebounceOptions debounce);

    Plug hear(Instant now) override;

  private:
    bool is_closed(Button button) const;

    std::unique_ptr<EvdevStream> stream_;
    ControlReader reader_;
    Bindings bindings_;
    KernelClock clock_;
};

}  // namespace quadrat::firmware_io::evdev
