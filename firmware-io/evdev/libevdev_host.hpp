// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "firmware-io/evdev/bindings.hpp"
#include "firmware-io/folder_watch.hpp"

namespace quadrat::firmware_io::evdev {

// The event devices of this machine. They are listed from sysfs, which needs no rights and disturbs nobody; opened and
// read through libevdev.
class LibevdevHost final : public EvdevHost {
  public:
    explicit LibevdevHost(std::filesystem::path listing = "/sys/class/input",
                          std::filesystem::path nodes = "/dev/input")
        : listing_{std::move(listing)}, nodes_{std::move(nodes)}, watch_{nodes_, "event"} {}

    std::vector<EvdevDeviceFacts> devices() override;
    bool take_news() override { return watch_.take_news(); }
    std::unique_ptr<EvdevStream> open(const std::string& path, Grab grab, std::string& trouble) override;

  private:
    std::filesystem::path listing_, nodes_;
    FolderWatch watch_;
};

// The codes in a "capabilities" file of sysfs: words of the kernel's unsigned long in hexadecimal, the highest first.
// For any text; ascending.
std::vector<Code> parse_capabilities(std::string_view text);

// "BTN_SOUTH", "KEY_A", "ABS_Z+", "ABS_HAT0X-", as evtest and the kernel call them. Nothing: there is no such control.
std::optional<Signal> signal_named(std::string_view name);

}  // namespace quadrat::firmware_io::evdev
