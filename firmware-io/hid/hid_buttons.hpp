// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/button_source.hpp"
#include "firmware-io/heard_boards.hpp"
#include "firmware-io/heard_devices.hpp"
#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/hid_host.hpp"
#include "firmware-io/hid/mapping.hpp"

namespace quadrat::firmware_io::hid {

// With nothing given, the likeliest that can be pressed at all.
using HidSelector = DeviceSelector;
inline bool is_meant(const HidSelector& selector, const HidDeviceFacts& device) {
    return firmware_io::is_meant(selector, device.identity, device.path);
}

// Gamepads, arcade encoders or keyboards through their raw reports. Of those that are meant, the likeliest is heard
// with all its interfaces (a board that shows a game controller may send from its keyboard), its equals in other ports,
// and every other device that was taught. A path stands for the whole board. Edges carry the moment they were read.
//
// Devices are looked for once a second, and at once where the host tells. What a device reports as pressed within 200
// ms of opening was held before and is no press. (A device that reports nothing until something changes cannot be
// asked: that call may block for seconds.)
class HidButtons final : public ButtonSource {
  public:
    // A device with a mapping is preferred to others, and its mapping to the default bindings.
    HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce = {},
               std::vector<HidMapping> mappings = {}, std::shared_ptr<HeardBoards> boards = {});
    ~HidButtons() override;

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return status_; }
    SourceStatus look() override;
    const Contacts& contacts() const override { return heard_.contacts(); }
    std::optional<Instant> next_event_at() const override { return heard_.next_event_at(); }

  private:
    struct Candidate {
        HidDeviceFacts device;
        HidLayout layout;
        Bindings bindings;
        int likelihood;
        bool is_mouse;
    };
    std::vector<HidDeviceFacts> meant() const;
    std::optional<Candidate> candidate(HidDeviceFacts device) const;
    std::vector<Candidate> candidates() const;
    static bool goes_with(const Candidate& other, const Candidate& first);
    void look_for(Instant now);
    bool open(Candidate& candidate, Instant now);
    SourceStatus nothing_plugged_in() const;
    void tell(Instant now);

    std::unique_ptr<HidHost> host_;
    HidSelector selector_;
    DebounceOptions debounce_;
    std::vector<HidMapping> mappings_;
    std::shared_ptr<HeardBoards> boards_;
    HeardDevices heard_;
    SourceStatus status_;
    std::optional<Instant> look_at_;
    std::string refused_;  // who cannot be opened, and why
    std::optional<Instant> unplugged_at_;
};

}  // namespace quadrat::firmware_io::hid
