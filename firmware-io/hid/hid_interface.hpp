// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "firmware-io/heard_boards.hpp"
#include "firmware-io/heard_devices.hpp"
#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/hid_host.hpp"
#include "firmware-io/hid/report_reader.hpp"

namespace quadrat::firmware_io::hid {

// One opened hidraw node, and which of its signals close which contact. As long as it lives, its board counts as heard.
class HidInterface final : public HeardDevice {
  public:
    struct Opened {
        const HidDeviceFacts& device;
        std::unique_ptr<HidStream> stream;
        HidLayout layout;
        Bindings bindings;
        Instant at;
    };
    HidInterface(Opened opened, DebounceOptions debounce, std::shared_ptr<HeardBoards> boards);
    ~HidInterface() override;

    Plug hear(Instant now) override;

  private:
    void follow(Instant now);

    std::unique_ptr<HidStream> stream_;
    ReportReader reader_;
    Bindings bindings_;
    Instant opened_at_;
    std::shared_ptr<HeardBoards> boards_;
};

}  // namespace quadrat::firmware_io::hid
