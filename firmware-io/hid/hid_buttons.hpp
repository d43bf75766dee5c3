// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/button_source.hpp"
#include "firmware-io/debounce.hpp"
#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/hid_host.hpp"
#include "firmware-io/hid/mapping.hpp"
#include "firmware-io/hid/report_reader.hpp"

namespace quadrat::firmware_io::hid {

// Which device is meant. What is not given is any; with nothing given, the likeliest that can be pressed at all.
struct HidSelector {
    std::optional<std::uint16_t> vendor, product;
    std::string path;  // "/dev/hidraw3"
    std::string port;  // the beginning of HidIdentity::port, up to a '/' or its end
    friend bool operator==(const HidSelector&, const HidSelector&) = default;
};
bool is_meant(const HidSelector& selector, const HidDeviceFacts& device);
std::string to_string(const HidSelector& selector);  // "HID device 0079:0006 at usb-1"

// A gamepad, arcade encoder or keyboard through its raw reports. Its edges carry the moment they were read. Unplugged,
// it is looked for once a second. What the device reports as pressed within 200 ms of opening was held before and is no
// press. (A device that reports nothing until something changes cannot be asked: that call may block for seconds.)
class HidButtons final : public ButtonSource {
  public:
    // A device with a mapping is preferred to others, and its mapping to the default bindings.
    HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce = {},
               std::vector<HidMapping> mappings = {});

    std::vector<ButtonEdge> poll(Instant now) override;
    SourceStatus status() const override { return status_; }
    SourceStatus look() override;
    const Contacts& contacts() const override { return debouncer_.contacts(); }
    std::optional<Instant> next_event_at() const override { return debouncer_.next_event_at(); }

  private:
    struct Candidate {
        HidDeviceFacts device;
        HidLayout layout;
        Bindings bindings;
        int likelihood;
    };
    std::vector<Candidate> candidates();
    SourceStatus nothing_plugged_in() const;
    void open(Instant now);
    bool open(Candidate& candidate, Instant now);
    void lose(Instant now);
    void follow(Instant now);

    std::unique_ptr<HidHost> host_;
    HidSelector selector_;
    std::vector<HidMapping> mappings_;
    Debouncer debouncer_;
    std::unique_ptr<HidStream> stream_;  // null while absent
    ReportReader reader_{HidLayout{}};
    Bindings bindings_;
    SourceStatus status_;
    std::optional<Instant> retry_at_;
    Instant opened_at_{0};
};

}  // namespace quadrat::firmware_io::hid
