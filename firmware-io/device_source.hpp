// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firmware-io/button_source.hpp"
#include "firmware-io/device.hpp"
#include "firmware-io/heard_devices.hpp"

namespace quadrat::firmware_io {

// A device on a cable that could be heard.
struct FoundDevice {
    std::string path;
    DeviceIdentity identity;
    int likelihood = 0;        // that a visitor's buttons are on it: higher is likelier
    bool may_be_first = true;  // it may be heard though no other brings it along
    bool is_taught = false;    // somebody said what its controls mean
    bool is_pointing = false;  // a mouse, say: not heard beside a board's other interfaces
    // Null if it cannot be opened; `trouble` then says why.
    std::function<std::unique_ptr<HeardDevice>(Instant now, std::string& trouble)> open = {};
};

// Where sources of devices on cables differ in what they say.
struct DeviceWords {
    std::string kind;         // "HID device"
    std::string plug_in;      // what to do where none is there
    std::string let_it_open;  // what to do where it cannot be opened, besides the udev rule
};

// Buttons on devices that are plugged in and out. Of those that are found, the likeliest that can be opened is heard,
// with all its interfaces, its equals in other ports, and every other device that was taught; whichever was plugged in
// first. They are looked for once a second, and at once where the host tells.
class DeviceSource : public ButtonSource {
  public:
    std::vector<ButtonEdge> poll(Instant now) final;
    SourceStatus status() const final { return status_; }
    SourceStatus look() final;
    const Contacts& contacts() const final { return heard_.contacts(); }
    std::optional<Instant> next_event_at() const final { return heard_.next_event_at(); }

  protected:
    DeviceSource(DeviceWords words, DeviceSelector selector);

    const DeviceSelector& selector() const { return selector_; }
    // Those that are meant and have something to press, in a steady order.
    virtual std::vector<FoundDevice> find() const = 0;
    // Whether something was plugged in or out since the last call, where that is known at once.
    virtual bool take_news() = 0;
    // Whether another source hears that board already. It may begin to later.
    virtual bool is_left_alone(const DeviceIdentity&) const { return false; }

  private:
    std::vector<FoundDevice> candidates();
    void leave_alone(Instant now);
    void look_for(Instant now);
    bool open(const FoundDevice& device, Instant now);
    SourceStatus nothing_plugged_in() const;
    void tell(Instant now);

    DeviceWords words_;
    DeviceSelector selector_;
    HeardDevices heard_;
    SourceStatus status_;
    std::optional<Instant> look_at_;
    std::string refused_;     // who cannot be opened, and why
    std::string left_alone_;  // who is heard by another source already
    std::optional<Instant> unplugged_at_;
};

}  // namespace quadrat::firmware_io
