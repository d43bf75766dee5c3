// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/control_reader.hpp"

#include <linux/input-event-codes.h>

#include <array>

namespace quadrat::firmware_io::evdev {
namespace {

struct Pair {
    Code sideways, upright;
};
constexpr std::array kSticks{Pair{ABS_X, ABS_Y}, Pair{ABS_RX, ABS_RY}};
constexpr std::array kHats{Pair{ABS_HAT0X, ABS_HAT0Y}, Pair{ABS_HAT1X, ABS_HAT1Y}, Pair{ABS_HAT2X, ABS_HAT2Y},
                           Pair{ABS_HAT3X, ABS_HAT3Y}};

bool is_of_stick(Code code) {
    for (const Pair& stick : kSticks)
        if (code == stick.sideways || code == stick.upright) return true;
    return false;
}

bool is_usable(const Axis& axis) {
    if (axis.maximum <= axis.minimum) return false;
    return !is_of_stick(axis.code) || (axis.minimum < 0 && axis.maximum > 0);
}

}  // namespace

ControlReader::ControlReader(const Controls& at_opening) : held_{at_opening.held.begin(), at_opening.held.end()} {
    for (const Axis& axis : at_opening.axes)
        if (is_usable(axis)) axes_[axis.code].axis = axis;
    tell();
}

ControlReader::End ControlReader::end_of(const AxisState& state) {
    const Axis& axis = state.axis;
    const std::int64_t range = std::int64_t{axis.maximum} - axis.minimum;
    const auto is_at = [&](std::int64_t from_end, End end) {
        return from_end * 8 <= range * (state.end == end ? 3 : 2);
    };
    if (is_at(std::int64_t{axis.value} - axis.minimum, End::Low)) return End::Low;
    return is_at(std::int64_t{axis.maximum} - axis.value, End::High) ? End::High : End::None;
}

void ControlReader::tell() {
    const std::map<Code, AxisState> before = axes_;
    for (auto& [code, state] : axes_) {
        state.end = end_of(state);
        state.is_told = state.end != End::None;
    }
    const auto choose = [&](const Pair& pair) {
        const auto sideways = axes_.find(pair.sideways), upright = axes_.find(pair.upright);
        if (sideways == axes_.end() || upright == axes_.end()) return;
        if (!sideways->second.is_told || !upright->second.is_told) return;
        const AxisState& was = before.at(pair.sideways);
        const bool is_sideways_kept = was.is_told && was.end == sideways->second.end;
        (is_sideways_kept ? upright : sideways)->second.is_told = false;
    };
    for (const Pair& pair : kSticks) choose(pair);
    for (const Pair& pair : kHats) choose(pair);
}

void ControlReader::take(const ControlEvent& event) {
    switch (event.kind) {
        case ControlKind::Key:
            if (event.value == 0)
                held_.erase(event.code);
            else
                held_.insert(event.code);  // 1, and 2 for a key that repeats
            break;
        case ControlKind::Axis:
            if (const auto found = axes_.find(event.code); found != axes_.end()) found->second.axis.value = event.value;
            break;
        case ControlKind::Report:
            tell();
            break;
    }
}

bool ControlReader::is_pressed(const Signal& signal) const {
    if (signal.part == SignalPart::Key) return held_.contains(signal.code);
    const auto found = axes_.find(signal.code);
    if (found == axes_.end() || !found->second.is_told) return false;
    return found->second.end == (signal.part == SignalPart::Low ? End::Low : End::High);
}

}  // namespace quadrat::firmware_io::evdev
