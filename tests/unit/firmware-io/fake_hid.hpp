// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <deque>
#include <memory>

#include "firmware-io/hid/hid_host.hpp"

namespace quadrat::tests {

namespace hid = firmware_io::hid;
using Bytes = std::vector<std::uint8_t>;

// A device at the end of a cable. Plugged in again it gets another path, as the kernel gives it.
struct FakeHidDevice {
    hid::HidDeviceFacts facts;
    std::deque<Bytes> reports;
    std::string refusal;  // why opening fails, or ""
    bool is_plugged = true;
    unsigned plugging = 0;
    unsigned opened = 0;

    void send(Bytes report) {
        if (is_plugged) reports.push_back(std::move(report));
        if (reports.size() > 64) reports.pop_front();  // the kernel's ring
    }
    void unplug() { is_plugged = false; }
    void plug() {
        is_plugged = true;
        facts.path = "/dev/hidraw" + std::to_string(++plugging % 7);
        reports.clear();
    }
};
using FakeHidDevices = std::vector<std::shared_ptr<FakeHidDevice>>;

class FakeHidStream : public hid::HidStream {
  public:
    explicit FakeHidStream(std::shared_ptr<FakeHidDevice> device)
        : device_{std::move(device)}, plugging_{device_->plugging} {}
    std::ptrdiff_t read(std::span<std::uint8_t> report) override {
        if (!device_->is_plugged || device_->plugging != plugging_) return kGone;
        if (device_->reports.empty()) return kNothing;
        const Bytes bytes = device_->reports.front();
        device_->reports.pop_front();
        std::copy(bytes.begin(), bytes.end(), report.begin());
        return static_cast<std::ptrdiff_t>(bytes.size());
    }

  private:
    std::shared_ptr<FakeHidDevice> device_;
    unsigned plugging_;
};

class FakeHidHost : public hid::HidHost {
  public:
    explicit FakeHidHost(FakeHidDevices devices) : devices_{std::move(devices)} {}
    std::vector<hid::HidDeviceFacts> devices() override {
        std::vector<hid::HidDeviceFacts> facts;
        for (const auto& device : devices_)
            if (device->is_plugged) facts.push_back(device->facts);
        return facts;
    }
    std::unique_ptr<hid::HidStream> open(const std::string& path, std::string& trouble) override {
        for (const auto& device : devices_) {
            if (!device->is_plugged || device->facts.path != path) continue;
            trouble = device->refusal;
            if (!trouble.empty()) return nullptr;
            ++device->opened;
            return std::make_unique<FakeHidStream>(device);
        }
        trouble = "No such file or directory";
        return nullptr;
    }

  private:
    FakeHidDevices devices_;
};

// Five buttons in one byte, bit 0 is A: what the simplest encoder sends.
inline const Bytes kFiveButtons{0x05, 0x01, 0x09, 0x05, 0xa1, 0x01, 0x05, 0x09, 0x19, 0x01,
                                0x29, 0x05, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x05,
                                0x81, 0x02, 0x75, 0x03, 0x95, 0x01, 0x81, 0x03, 0xc0};

inline std::shared_ptr<FakeHidDevice> five_button_device() {
    auto device = std::make_shared<FakeHidDevice>();
    device->facts = {"/dev/hidraw0", {0x1209, 0x0001, "Five buttons", "", "usb-0000:00:14.0-1/input0"}, kFiveButtons};
    return device;
}

}  // namespace quadrat::tests
