// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "firmware-io/device_source.hpp"
#include "firmware-io/heard_boards.hpp"
#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/hid_host.hpp"
#include "firmware-io/hid/mapping.hpp"

namespace quadrat::firmware_io::hid {

// With nothing given, the likeliest that can be pressed at all.
using HidSelector = DeviceSelector;
inline bool is_meant(const HidSelector& selector, const HidDeviceFacts& device) {
    return firmware_io::is_meant(selector, device.identity, device.path);
}

// Gamepads, arcade encoders or keyboards through their raw reports. A board that shows a game controller may send from
// its keyboard. Edges carry the moment they were read.
//
// What a device reports as pressed within 200 ms of opening was held before and is no press. (A device that reports
// nothing until something changes cannot be asked: that call may block for seconds.)
class HidButtons final : public DeviceSource {
  public:
    // A device with a mapping is preferred to others, and its mapping to the default bindings.
    HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce = {},
               std::vector<HidMapping> mappings = {}, std::shared_ptr<HeardBoards> boards = {});
    ~HidButtons() override;

  private:
    std::vector<FoundDevice> find() const override;
    std::optional<FoundDevice> candidate(HidDeviceFacts device) const;
    bool take_news() override { return host_->take_news(); }

    std::unique_ptr<HidHost> host_;
    DebounceOptions debounce_;
    std::vector<HidMapping> mappings_;
    std::shared_ptr<HeardBoards> boards_;
};

}  // namespace quadrat::firmware_io::hid
