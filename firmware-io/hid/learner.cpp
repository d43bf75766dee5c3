// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/learner.hpp"

#include <algorithm>

#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::hid {
namespace {

bool holds(std::span<const HidSignal> signals, const HidSignal& signal) {
    return std::find(signals.begin(), signals.end(), signal) != signals.end();
}

int rank(SignalPart part) {
    if (part == SignalPart::Pressed) return 0;
    return part == SignalPart::Low || part == SignalPart::High ? 2 : 1;
}

}  // namespace

std::optional<HidSignal> pressed_control(std::span<const HidSignal> at_rest, std::span<const HidSignal> held,
                                         std::span<const HidSignal> let_go) {
    std::optional<HidSignal> best;
    bool is_tie = false;
    for (const HidSignal& signal : held) {
        if (holds(at_rest, signal) || holds(let_go, signal)) continue;
        if (best && rank(signal.part) > rank(best->part)) continue;
        is_tie = best && rank(signal.part) == rank(best->part);
        best = signal;
    }
    return is_tie ? std::nullopt : best;
}

Learner::Learner(HidDeviceFacts device)
    : identity_{std::move(device.identity)}, reader_{parse_descriptor(device.descriptor)} {}

std::optional<Button> Learner::asked() const {
    return asked_ < kButtons.size() ? std::optional{kButtons[asked_]} : std::nullopt;
}

void Learner::skip() {
    if (asked()) ++asked_;
    trouble_.clear();
}

void Learner::report(std::span<const std::uint8_t> report) {
    reader_.read(report);
    const std::vector<HidSignal> now = reader_.pressed();
    held_.insert(now.begin(), now.end());
    const bool is_any_held = std::any_of(now.begin(), now.end(), [&](const HidSignal& signal) {
        return rank(signal.part) < 2 && !holds(at_rest_, signal);
    });
    const bool has_gone = std::any_of(held_.begin(), held_.end(), [&](const HidSignal& signal) {
        return !holds(now, signal) && !holds(at_rest_, signal);
    });
    if (is_any_held && has_gone) trouble_ = "another control is still held; let go of everything";
    if (is_any_held || !has_gone) return;
    const std::vector<HidSignal> held{held_.begin(), held_.end()};
    const auto control = pressed_control(at_rest_, held, now);
    at_rest_ = now;
    held_.clear();
    if (control)
        learn(*control);
    else
        trouble_ = "several controls moved at once; press one button and let it go";
}

void Learner::learn(const HidSignal& signal) {
    if (!asked()) return;
    const auto taken = std::find_if(bindings_.begin(), bindings_.end(),
                                    [&](const Binding& binding) { return binding.signal == signal; });
    if (taken != bindings_.end()) {
        trouble_ = "that is button " + std::string{name_of(taken->button)} + " already; press another";
        return;
    }
    bindings_.push_back({signal, *asked()});
    ++asked_;
    trouble_.clear();
}

HidMapping Learner::mapping() const {
    return {identity_.vendor, identity_.product, one_word(identity_.serial), one_word(identity_.port), bindings_};
}

}  // namespace quadrat::firmware_io::hid
