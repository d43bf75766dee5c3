// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firmware-io/device.hpp"

// What we need of the machine's HID devices, and no more: hidraw stands behind it, and so does a fake.
namespace quadrat::firmware_io::hid {

using HidIdentity = DeviceIdentity;

struct HidDeviceFacts {
    std::string path;  // "/dev/hidraw3": another one after each plugging
    HidIdentity identity;
    std::vector<std::uint8_t> descriptor;
};

class HidStream {
  public:
    virtual ~HidStream() = default;
    static constexpr std::ptrdiff_t kNothing = 0, kGone = -1;
    // One report into `report`: its length with the report ID, kNothing if none waits, kGone once unplugged. Never
    // blocks.
    virtual std::ptrdiff_t read(std::span<std::uint8_t> report) = 0;
};

class HidHost {
  public:
    virtual ~HidHost() = default;
    virtual std::vector<HidDeviceFacts> devices() = 0;  // each path once, in a steady order
    // Whether something was plugged in or out since the last call, where that is known at once.
    virtual bool take_news() { return false; }
    // Null if it cannot be opened; `trouble` then says why.
    virtual std::unique_ptr<HidStream> open(const std::string& path, std::string& trouble) = 0;
};

}  // namespace quadrat::firmware_io::hid
