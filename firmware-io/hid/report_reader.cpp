// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/report_reader.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace quadrat::firmware_io::hid {
namespace {

std::int64_t field(std::span<const std::uint8_t> body, std::uint32_t bit, unsigned bits, bool is_signed) {
    if (bits == 0) return 0;
    std::uint64_t value = 0;
    for (unsigned i = 0; i < bits; ++i) {
        const std::size_t byte = (bit + i) / 8;
        if (byte < body.size()) value |= std::uint64_t{body[byte] >> (bit + i) % 8 & 1u} << i;
    }
    const bool is_negative = is_signed && (value >> (bits - 1) & 1u) != 0;
    return static_cast<std::int64_t>(value) - (is_negative ? std::int64_t{1} << bits : 0);
}

// The directions of a hat: eight or four of them clockwise from above, everything else centred.
std::vector<SignalPart> directions(const Variable& hat, std::int64_t value) {
    const std::int64_t count = hat.logical_max - hat.logical_min + 1;
    const std::int64_t step = value - hat.logical_min;
    if ((count != 8 && count != 4) || step < 0 || step >= count) return {};
    const std::int64_t eighth = step * 8 / count;
    const auto part = [](std::int64_t quarter) {
        return static_cast<SignalPart>(static_cast<std::int64_t>(SignalPart::Up) + quarter % 4);
    };
    if (eighth % 2 == 0) return {part(eighth / 2)};
    const SignalPart one = part(eighth / 2), other = part(eighth / 2 + 1);
    const bool is_one_upright = one == SignalPart::Up || one == SignalPart::Down;
    return is_one_upright ? std::vector{one, other} : std::vector{other, one};
}

// How far inside the range an end of the axis still counts as pressed.
bool is_at_end(const Variable& axis, std::int64_t value, SignalPart end, bool was_pressed) {
    const std::int64_t range = axis.logical_max - axis.logical_min;
    const std::int64_t from_end = end == SignalPart::Low ? value - axis.logical_min : axis.logical_max - value;
    return from_end * 8 <= range * (was_pressed ? 3 : 2);
}

}  // namespace

void ReportReader::press(std::uint16_t collection, Usage usage, SignalPart part) {
    after_.push_back({collection, usage, part});
}

bool ReportReader::was_pressed(const Variable& variable, SignalPart part) const {
    return std::binary_search(before_.begin(), before_.end(), HidSignal{variable.collection, variable.usage, part});
}

void ReportReader::read_variable(const Variable& v, std::span<const std::uint8_t> body) {
    const std::int64_t raw = field(body, v.bit, v.bits, v.is_signed);
    if (v.kind == ControlKind::Hat) {
        const auto pushed = directions(v, raw);
        const auto kept =
            std::find_if(pushed.begin(), pushed.end(), [&](SignalPart direction) { return was_pressed(v, direction); });
        if (!pushed.empty()) press(v.collection, v.usage, kept != pushed.end() ? *kept : pushed.front());
        return;
    }
    const std::int64_t value = std::clamp(raw, v.logical_min, v.logical_max);
    if (v.kind == ControlKind::Axis) {
        if (v.bit + v.bits > body.size() * 8) return;  // zero would be an end of the axis
        for (const SignalPart end : {SignalPart::Low, SignalPart::High})
            if (is_at_end(v, value, end, was_pressed(v, end))) press(v.collection, v.usage, end);
    } else if ((value - v.logical_min) * 2 >= v.logical_max - v.logical_min && value != v.logical_min) {
        press(v.collection, v.usage, SignalPart::Pressed);  // buttons that measure pressure count from half of it
    }
}

namespace {

// The usage that the index into an array's usages stands for; 0 beyond their end.
Usage usage_at(const Array& array, std::int64_t index) {
    for (const UsageRange& range : array.usages) {
        const std::int64_t length = std::int64_t{range.last} - range.first + 1;
        if (index < length) return range.first + static_cast<Usage>(index);
        index -= length;
    }
    return 0;
}

// ErrorRollOver, POSTFail, ErrorUndefined: the keyboard cannot tell which keys are down.
bool is_key_error(Usage u) { return u >= usage(page::kKeyboard, 0x01) && u <= usage(page::kKeyboard, 0x03); }

bool is_among(const Array& array, const HidSignal& signal) {
    const auto holds = [&](const UsageRange& r) { return r.first <= signal.usage && signal.usage <= r.last; };
    return array.collection == signal.collection && std::any_of(array.usages.begin(), array.usages.end(), holds);
}

}  // namespace

void ReportReader::read_array(const Array& array, std::span<const std::uint8_t> body) {
    std::vector<HidSignal> named;
    for (std::uint32_t slot = 0; slot < array.slots; ++slot) {
        const std::int64_t value = field(body, array.bit + slot * array.bits, array.bits, array.is_signed);
        if (value < array.logical_min || value > array.logical_max) continue;
        const Usage usage = usage_at(array, value - array.logical_min);
        if (is_key_error(usage)) {
            named.clear();
            std::copy_if(before_.begin(), before_.end(), std::back_inserter(named),
                         [&](const HidSignal& signal) { return is_among(array, signal); });
            break;
        }
        // A value of 0 is nothing; where the values begin later, a box that numbers its buttons from 0 means its first.
        const bool is_first_of_box = page_of(usage) == page::kButton && value != 0;
        if ((usage & 0xffffu) != 0 || is_first_of_box) named.push_back({array.collection, usage, SignalPart::Pressed});
    }
    after_.insert(after_.end(), named.begin(), named.end());
}

void ReportReader::read(std::span<const std::uint8_t> report) {
    std::uint8_t id = 0;
    if (layout_.has_report_ids) {
        if (report.empty()) return;
        id = report.front();
        report = report.subspan(1);
    }
    before_ = std::move(pressed_by_report_[id]);
    after_.clear();
    for (const Variable& variable : layout_.variables)
        if (variable.report_id == id) read_variable(variable, report);
    for (const Array& array : layout_.arrays)
        if (array.report_id == id) read_array(array, report);
    std::sort(after_.begin(), after_.end());
    after_.erase(std::unique(after_.begin(), after_.end()), after_.end());
    pressed_by_report_[id] = after_;
}

std::vector<HidSignal> ReportReader::pressed() const {
    std::vector<HidSignal> all;
    for (const auto& [id, signals] : pressed_by_report_) all.insert(all.end(), signals.begin(), signals.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace quadrat::firmware_io::hid
