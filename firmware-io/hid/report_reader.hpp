// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>

#include "firmware-io/hid/hid_layout.hpp"

namespace quadrat::firmware_io::hid {

// What is pressed on a device, from the reports it sends. Each report is the whole state of its controls, so a lost
// report costs nothing but its moment. For any bytes: bits beyond the end of a short report read as zero, an unknown
// report ID is ignored.
//
// Values outside the declared range are clamped (Xin-Mo boards declare -1 and send -2), but for hats, where they mean
// centred. A hat presses one direction at a time: on a diagonal the direction it came from, from the centre the upright
// one. An axis is pressed in the outer quarter of its range and let go inside three eighths.
class ReportReader {
  public:
    explicit ReportReader(HidLayout layout) : layout_{std::move(layout)} {}

    const HidLayout& layout() const { return layout_; }
    void read(std::span<const std::uint8_t> report);
    std::vector<HidSignal> pressed() const;  // sorted, each once

  private:
    void read_variable(const Variable& variable, std::span<const std::uint8_t> body);
    void read_array(const Array& array, std::span<const std::uint8_t> body);
    bool was_pressed(const Variable& variable, SignalPart part) const;
    void press(std::uint16_t collection, Usage usage, SignalPart part);

    HidLayout layout_;
    std::map<std::uint8_t, std::vector<HidSignal>> pressed_by_report_;
    std::vector<HidSignal> before_, after_;  // of the report being read
};

}  // namespace quadrat::firmware_io::hid
