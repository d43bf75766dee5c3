// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <linux/input-event-codes.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "firmware-io/evdev/evdev_host.hpp"

namespace quadrat::tests {

namespace evdev = firmware_io::evdev;
using firmware_io::Instant;

// An input device as the kernel shows it: the state of its controls, and a buffer of events that overflows. Plugged in
// again it gets another path.
struct FakeEvdevDevice {
    // The zero of the kernel's clock lies somewhere else than ours.
    static constexpr Instant kKernelZero = std::chrono::hours{40};
    static constexpr std::size_t kBuffer = 64;
    evdev::EvdevDeviceFacts facts;
    std::set<evdev::Code> held;
    std::map<evdev::Code, evdev::Axis> axes;
    std::deque<evdev::ControlEvent> events;
    bool has_overflowed = false;
    std::string refusal;  // why opening fails, or ""
    evdev::Grab grab = evdev::Grab::No;
    bool is_plugged = true;
    unsigned plugging = 0, opened = 0;

    void key(evdev::Code code, bool is_down, Instant at) {
        if (is_down == held.contains(code)) return;
        if (is_down)
            held.insert(code);
        else
            held.erase(code);
        send({evdev::ControlKind::Key, code, is_down, kKernelZero + at});
    }
    void axis(evdev::Code code, std::int32_t value, Instant at) {
        axes[code].value = value;
        send({evdev::ControlKind::Axis, code, value, kKernelZero + at});
    }
    void send(const evdev::ControlEvent& event) {
        if (!is_plugged || opened == 0) return;
        events.push_back(event);
        events.push_back({evdev::ControlKind::Report, 0, 0, event.kernel_time});
        if (events.size() <= kBuffer) return;
        events.clear();
        has_overflowed = true;
    }
    void unplug() { is_plugged = false; }
    void plug() {
        is_plugged = true;
        facts.path = "/dev/input/event" + std::to_string(++plugging % 7);
        events.clear();
    }
};
using FakeEvdevDevices = std::vector<std::shared_ptr<FakeEvdevDevice>>;

class FakeEvdevStream : public evdev::EvdevStream {
  public:
    explicit FakeEvdevStream(std::shared_ptr<FakeEvdevDevice> device)
        : device_{std::move(device)}, plugging_{device_->plugging}, told_{device_->held} {
        at_opening_.held.assign(told_.begin(), told_.end());
        for (const auto& [code, axis] : device_->axes) at_opening_.axes.push_back(axis);
        device_->events.clear();
        device_->has_overflowed = false;
    }
    const evdev::Controls& at_opening() const override { return at_opening_; }
    Took take(evdev::ControlEvent& event) override {
        if (!device_->is_plugged || device_->plugging != plugging_) return Took::Gone;
        if (std::exchange(device_->has_overflowed, false)) catch_up();
        if (device_->events.empty()) return Took::Nothing;
        event = device_->events.front();
        device_->events.pop_front();
        if (event.kind == evdev::ControlKind::Key && event.value != 0) told_.insert(event.code);
        if (event.kind == evdev::ControlKind::Key && event.value == 0) told_.erase(event.code);
        return Took::Event;
    }

  private:
    void catch_up() {
        const Instant at = device_->events.empty() ? Instant{0} : device_->events.back().kernel_time;
        device_->events.clear();
        for (const evdev::Code code : device_->facts.keys)
            if (told_.contains(code) != device_->held.contains(code))
                device_->events.push_back({evdev::ControlKind::Key, code, device_->held.contains(code), at});
        device_->events.push_back({evdev::ControlKind::Report, 0, 0, at});
    }

    std::shared_ptr<FakeEvdevDevice> device_;
    unsigned plugging_;
    std::set<evdev::Code> told_;
    evdev::Controls at_opening_;
};

class FakeEvdevHost : public evdev::EvdevHost {
  public:
    explicit FakeEvdevHost(FakeEvdevDevices devices) : devices_{std::move(devices)} {}
    std::vector<evdev::EvdevDeviceFacts> devices() override {
        std::vector<evdev::EvdevDeviceFacts> facts;
        for (const auto& device : devices_)
            if (device->is_plugged) facts.push_back(device->facts);
        return facts;
    }
    std::unique_ptr<evdev::EvdevStream> open(const std::string& path, evdev::Grab grab, std::string& trouble) override {
        for (const auto& device : devices_) {
            if (!device->is_plugged || device->facts.path != path) continue;
            trouble = device->refusal;
            if (!trouble.empty()) return nullptr;
            ++device->opened;
            device->grab = grab;
            return std::make_unique<FakeEvdevStream>(device);
        }
        trouble = "No such file or directory";
        return nullptr;
    }

  private:
    FakeEvdevDevices devices_;
};

inline std::shared_ptr<FakeEvdevDevice> evdev_device(const std::string& path, std::vector<evdev::Code> keys,
                                                     const std::vector<evdev::Axis>& axes = {}) {
    auto device = std::make_shared<FakeEvdevDevice>();
    std::sort(keys.begin(), keys.end());
    device->facts = {path, {0x1209, 0x0001, "Five buttons", "", "usb-0000:00:14.0-1/input0"}, std::move(keys), {}};
    for (const evdev::Axis& axis : axes) {
        device->facts.axes.push_back(axis.code);
        device->axes[axis.code] = axis;
    }
    return device;
}

// Five buttons of a joystick, A first.
inline const std::vector<evdev::Code> kFiveKeys{BTN_TRIGGER, BTN_THUMB, BTN_THUMB2, BTN_TOP, BTN_TOP2};

// A pad in X-input mode, as the kernel's xpad driver shows it.
inline std::shared_ptr<FakeEvdevDevice> x_input_pad() {
    auto pad = evdev_device("/dev/input/event5",
                            {BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT, BTN_START, BTN_MODE,
                             BTN_THUMBL, BTN_THUMBR},
                            {{ABS_X, -32768, 32767, 120},
                             {ABS_Y, -32768, 32767, -300},
                             {ABS_Z, 0, 255, 0},
                             {ABS_RX, -32768, 32767, 0},
                             {ABS_RY, -32768, 32767, 0},
                             {ABS_RZ, 0, 255, 0},
                             {ABS_HAT0X, -1, 1, 0},
                             {ABS_HAT0Y, -1, 1, 0}});
    pad->facts.identity = {0x45e, 0x28e, "Microsoft X-Box 360 pad", "", "usb-0000:00:14.0-2/input0"};
    return pad;
}

}  // namespace quadrat::tests
