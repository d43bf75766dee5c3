// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string_view>

#include "firmware-io/folder_watch.hpp"
#include "firmware-io/hid/hid_host.hpp"

namespace quadrat::firmware_io::hid {

// The identity in a HID device's "uevent" file of sysfs (HID_ID=0003:00000079:00000006, HID_NAME, HID_PHYS, HID_UNIQ).
// For any text; what is missing stays empty or 0.
HidIdentity parse_uevent(std::string_view uevent);

// The hidraw devices of this machine. They are listed from sysfs: one entry a device (hidapi lists one for each
// top-level usage), with the descriptor (which hidapi fetches only since 0.14) and the port (which it never tells), and
// fast enough to be repeated while the exhibit runs. Opened and read through hidapi.
class Hidraw final : public HidHost {
  public:
    explicit Hidraw(std::filesystem::path listing = "/sys/class/hidraw", std::filesystem::path nodes = "/dev")
        : listing_{std::move(listing)}, nodes_{std::move(nodes)}, watch_{nodes_, "hidraw"} {}

    std::vector<HidDeviceFacts> devices() override;
    bool take_news() override { return watch_.take_news(); }
    std::unique_ptr<HidStream> open(const std::string& path, std::string& trouble) override;

  private:
    std::filesystem::path listing_, nodes_;
    FolderWatch watch_;
};

}  // namespace quadrat::firmware_io::hid
