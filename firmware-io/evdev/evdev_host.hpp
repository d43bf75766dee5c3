// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "firmware-io/button_press.hpp"
#include "firmware-io/device.hpp"

// What we need of the kernel's input devices, and no more: libevdev stands behind it, and so does a fake. Codes are the
// kernel's own (linux/input-event-codes.h).
namespace quadrat::firmware_io::evdev {

using Code = std::uint16_t;

struct EvdevDeviceFacts {
    std::string path;  // "/dev/input/event3": another one after each plugging
    DeviceIdentity identity;
    std::vector<Code> keys;  // EV_KEY, ascending
    std::vector<Code> axes;  // EV_ABS, ascending
};

struct Axis {
    Code code = 0;
    std::int32_t minimum = 0, maximum = 0, value = 0;
};

// How the controls of a device stood when it was opened.
struct Controls {
    std::vector<Code> held;  // keys
    std::vector<Axis> axes;
};

enum class ControlKind { Key, Axis, Report };  // Report: what came before it happened together
struct ControlEvent {
    ControlKind kind = ControlKind::Report;
    Code code = 0;
    std::int32_t value = 0;
    Instant kernel_time{0};  // on the kernel's monotonic clock, whose zero is not ours
};

class EvdevStream {
  public:
    virtual ~EvdevStream() = default;
    virtual const Controls& at_opening() const = 0;
    enum class Took { Event, Nothing, Gone };
    // The next event, without waiting. After the kernel's buffer overflowed, what differs from what was told before is
    // told as events, so that whoever follows them knows the state again.
    virtual Took take(ControlEvent& event) = 0;
};

enum class Grab { No, Yes };  // Yes: what is pressed reaches nobody else, no console either

class EvdevHost {
  public:
    virtual ~EvdevHost() = default;
    virtual std::vector<EvdevDeviceFacts> devices() = 0;  // each path once, in a steady order
    // Whether something was plugged in or out since the last call, where that is known at once.
    virtual bool take_news() { return false; }
    // Null if it cannot be opened or another program has grabbed it; `trouble` then says why.
    virtual std::unique_ptr<EvdevStream> open(const std::string& path, Grab grab, std::string& trouble) = 0;
};

}  // namespace quadrat::firmware_io::evdev
