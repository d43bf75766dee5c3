// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/teaching.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io::hid {
namespace {
constexpr int kMostReports = 256;
constexpr std::size_t kLongestReport = 16'385;  // with its report ID
}  // namespace

Teaching::Teaching(HidHost& host, const HidSelector& selector) {
    for (HidDeviceFacts& device : host.devices()) {
        const HidLayout layout = parse_descriptor(device.descriptor);
        if (!is_meant(selector, device) || (layout.variables.empty() && layout.arrays.empty())) continue;
        std::string why;
        auto stream = host.open(device.path, why);
        if (stream)
            desks_.push_back({device, std::move(stream), Learner{device}});
        else
            trouble_ = device.path + " cannot be opened (" + why + "); run this as root, or install the udev rule";
    }
    if (desks_.empty() && trouble_.empty())
        trouble_ = in_words("HID device", selector) + " with buttons is not plugged in";
}

void Teaching::listen(std::size_t desk) {
    std::vector<std::uint8_t> report(kLongestReport);
    for (int i = 0; i < kMostReports; ++i) {
        const std::ptrdiff_t length = desks_[desk].stream->read(report);
        if (length == HidStream::kNothing) return;
        if (length < 0) {
            is_gone_ = is_gone_ || pupil_ == desk || desks_.size() == 1;
            trouble_ = desks_[desk].device.path + " was unplugged; plug it in and begin again";
            return;
        }
        if (pupil_ && *pupil_ != desk) continue;
        Learner& learner = desks_[desk].learner;
        learner.report(std::span{report}.first(static_cast<std::size_t>(length)));
        trouble_ = learner.trouble();
        if (!learner.mapping().bindings.empty()) pupil_ = desk;
    }
}

void Teaching::poll() {
    for (std::size_t i = 0; i < desks_.size() && !is_gone_; ++i) listen(i);
}

void Teaching::skip() {
    trouble_.clear();
    for (std::size_t i = 0; i < desks_.size(); ++i)
        if (!pupil_ || *pupil_ == i) desks_[i].learner.skip();
}

std::optional<Button> Teaching::asked() const {
    if (is_gone_ || desks_.empty()) return std::nullopt;
    return desks_[pupil_.value_or(0)].learner.asked();
}

std::optional<HidDeviceFacts> Teaching::pupil() const {
    if (!pupil_) return std::nullopt;
    return desks_[*pupil_].device;
}

HidMapping Teaching::mapping() const { return pupil_ ? desks_[*pupil_].learner.mapping() : HidMapping{}; }

}  // namespace quadrat::firmware_io::hid
