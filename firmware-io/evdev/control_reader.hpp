// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <set>

#include "firmware-io/evdev/bindings.hpp"

namespace quadrat::firmware_io::evdev {

// What is pressed on a device, from its events. For any events: an axis the device did not have when it was opened, or
// whose range is empty, is never pressed.
//
// An end of an axis is pressed in the outer quarter of its range and let go inside three eighths. Two axes that belong
// together (a hat, a stick) press one direction at a time: on a diagonal the one they came from, from the centre the
// upright one. A stick whose range does not lie around 0 rests anywhere, as far as anybody knows, and is never pressed.
class ControlReader {
  public:
    explicit ControlReader(const Controls& at_opening);

    void take(const ControlEvent& event);  // a Report is when directions are told anew
    bool is_pressed(const Signal& signal) const;

  private:
    enum class End : std::uint8_t { None, Low, High };
    struct AxisState {
        Axis axis;
        End end = End::None;   // where it is
        bool is_told = false;  // it is, and no direction of its partner goes before it
    };
    static End end_of(const AxisState& state);
    void tell();

    std::set<Code> held_;
    std::map<Code, AxisState> axes_;
};

}  // namespace quadrat::firmware_io::evdev
