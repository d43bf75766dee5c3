// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/button_source.hpp"
#include "firmware-io/evdev/bindings.hpp"
#include "firmware-io/heard_boards.hpp"
#include "firmware-io/heard_devices.hpp"

namespace quadrat::firmware_io::evdev {

struct EvdevOptions {
    DeviceSelector selector;
    DebounceOptions debounce;
    Grab grab = Grab::Yes;
    Bindings bindings;  // in place of the usual ones, on devices that can send any of them
};

// Pads in X-input mode, button boards with a driver of their own, and keyboards, as the kernel's own drivers tell of
// them. Of those that are meant, the likeliest is heard with all its interfaces and its equals in other ports; a path
// stands for the whole board. With no selector, a device is one with a pad's buttons or a keyboard's keys: not a power
// button. Edges carry the kernel's timestamps. Devices are looked for once a second, and at once where the host tells.
//
// A board that a hid: source listens to is left alone, also when that begins later (heard_boards.hpp).
class EvdevButtons final : public ButtonSource {
  public:
    EvdevButtons(std::unique_ptr<EvdevHost> host, EvdevOptions options, std::shared_ptr<const HeardBoards> boards = {});

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return status_; }
    SourceStatus look() override;
    const Contacts& contacts() const override { return heard_.contacts(); }
    std::optional<Instant> next_event_at() const override { return heard_.next_event_at(); }

  private:
    struct Candidate {
        EvdevDeviceFacts device;
        Bindings bindings;
        int likelihood;
    };
    bool may_be_first(const Candidate& one) const;
    static bool goes_with(const Candidate& other, const Candidate& first);
    std::vector<EvdevDeviceFacts> meant() const;
    std::vector<Candidate> candidates();
    bool is_left_alone(const DeviceIdentity& device) const { return boards_ && boards_->is_heard(board_of(device)); }
    void leave_alone(Instant now);
    void look_for(Instant now);
    bool open(Candidate& candidate, Instant now);
    SourceStatus nothing_plugged_in() const;
    void tell(Instant now);

    std::unique_ptr<EvdevHost> host_;
    EvdevOptions options_;
    std::shared_ptr<const HeardBoards> boards_;
    HeardDevices heard_;
    SourceStatus status_;
    std::optional<Instant> look_at_;
    std::string refused_;     // who cannot be opened, and why
    std::string left_alone_;  // who is heard by hid: already
    std::optional<Instant> unplugged_at_;
};

}  // namespace quadrat::firmware_io::evdev
