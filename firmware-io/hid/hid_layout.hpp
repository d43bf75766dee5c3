// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// What a HID report descriptor says about the reports a device sends: USB-IF, "Device Class Definition for HID 1.11",
// sections 5.4 and 6.2.2; usages from "HID Usage Tables 1.5".
namespace quadrat::firmware_io::hid {

// A usage page in the upper 16 bits, the usage in the lower.
using Usage = std::uint32_t;
inline constexpr Usage usage(unsigned page, unsigned id) { return page << 16 | id; }
inline constexpr unsigned page_of(Usage u) { return u >> 16; }

namespace page {
inline constexpr unsigned kDesktop = 0x01, kKeyboard = 0x07, kButton = 0x09, kConsumer = 0x0c, kVendorFirst = 0xff00;
}
inline constexpr Usage kMouse = usage(page::kDesktop, 0x02), kJoystick = usage(page::kDesktop, 0x04),
                       kGamepad = usage(page::kDesktop, 0x05), kKeyboardDevice = usage(page::kDesktop, 0x06),
                       kKeypadDevice = usage(page::kDesktop, 0x07), kHatSwitch = usage(page::kDesktop, 0x39);

enum class ControlKind { Button, Key, Hat, Axis };

// A field that holds the state of one control.
struct Variable {
    ControlKind kind;
    Usage usage;
    std::uint16_t collection;  // index into HidLayout::applications
    std::uint8_t report_id;    // 0: the device does not use report IDs
    std::uint32_t bit;         // where it begins in the report, the report ID not counted
    std::uint8_t bits;         // 1 to 32
    bool is_signed;
    std::int64_t logical_min, logical_max;
};

struct UsageRange {
    Usage first, last;  // both included
};

// A field whose slots each name one control that is pressed just now, as keyboards use it.
struct Array {
    std::uint16_t collection;
    std::uint8_t report_id;
    std::uint32_t bit;    // of the first slot
    std::uint8_t bits;    // of each slot, 1 to 32
    std::uint32_t slots;  // at least 1
    bool is_signed;
    std::int64_t logical_min, logical_max;
    std::vector<UsageRange> usages;  // logical_min means the first usage of the first range, and so on
};

struct HidLayout {
    std::vector<Usage> applications;  // of the top-level collections, in order
    std::vector<Variable> variables;
    std::vector<Array> arrays;
    bool has_report_ids = false;
    std::string trouble;  // why the descriptor was read only in part, or ""
};

// Something a person can press: a button or key, one direction of a hat, one end of an axis.
enum class SignalPart : std::uint8_t { Pressed, Up, Right, Down, Left, Low, High };
struct HidSignal {
    std::uint16_t collection;
    Usage usage;
    SignalPart part;
    friend auto operator<=>(const HidSignal&, const HidSignal&) = default;
};

// Whether a device of this layout can ever send the signal.
bool can_send(const HidLayout& layout, const HidSignal& signal);

// Pure, for any bytes: never throws but for want of memory, and its result is bounded (4096 bytes are read, 2048
// controls kept). A malformed descriptor gives what stands before the trouble.
HidLayout parse_descriptor(std::span<const std::uint8_t> descriptor);

}  // namespace quadrat::firmware_io::hid
