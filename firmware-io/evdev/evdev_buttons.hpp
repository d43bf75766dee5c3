// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/device_source.hpp"
#include "firmware-io/evdev/bindings.hpp"
#include "firmware-io/heard_boards.hpp"

namespace quadrat::firmware_io::evdev {

struct EvdevOptions {
    DeviceSelector selector;
    DebounceOptions debounce;
    Grab grab = Grab::Yes;
    Bindings bindings;  // in place of the usual ones, on devices that can send any of them
};

// Pads in X-input mode, button boards with a driver of their own, and keyboards, as the kernel's own drivers tell of
// them. With no selector, a device is one with a pad's buttons or a keyboard's keys: not a power button. Edges carry
// the kernel's timestamps.
//
// A board that a hid: source listens to is left alone, also when that begins later (heard_boards.hpp).
class EvdevButtons final : public DeviceSource {
  public:
    EvdevButtons(std::unique_ptr<EvdevHost> host, EvdevOptions options, std::shared_ptr<const HeardBoards> boards = {});

  private:
    std::vector<FoundDevice> find() const override;
    std::optional<FoundDevice> candidate(EvdevDeviceFacts device) const;
    bool take_news() override { return host_->take_news(); }
    bool is_left_alone(const DeviceIdentity& device) const override {
        return boards_ && boards_->is_heard(board_of(device));
    }

    std::unique_ptr<EvdevHost> host_;
    EvdevOptions options_;
    std::shared_ptr<const HeardBoards> boards_;
};

}  // namespace quadrat::firmware_io::evdev
