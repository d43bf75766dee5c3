// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/device_source.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;

constexpr Instant kLookEvery = 1s;

bool goes_with(const FoundDevice& other, const FoundDevice& first) {
    if (other.is_pointing && !first.is_pointing) return false;
    const DeviceIdentity &a = other.identity, &b = first.identity;
    return (a.vendor == b.vendor && a.product == b.product) || (other.is_taught && first.is_taught);
}

}  // namespace

DeviceSource::DeviceSource(DeviceWords words, DeviceSelector selector)
    : words_{std::move(words)},
      selector_{std::move(selector)},
      status_{Presence::Absent, in_words(words_.kind, selector_) + " has not been looked for yet"} {}

// The likeliest first.
std::vector<FoundDevice> DeviceSource::candidates() {
    std::vector<FoundDevice> found = find();
    left_alone_.clear();
    std::erase_if(found, [&](const FoundDevice& device) {
        if (!is_left_alone(device.identity)) return false;
        left_alone_ = describe(device.path, device.identity);
        return true;
    });
    std::stable_sort(found.begin(), found.end(),
                     [](const FoundDevice& a, const FoundDevice& b) { return a.likelihood > b.likelihood; });
    return found;
}

bool DeviceSource::open(const FoundDevice& device, Instant now) {
    if (heard_.has(device.path)) return true;
    std::string trouble;
    auto opened = device.open(now, trouble);
    if (!opened) {
        if (refused_.empty())
            refused_ = describe(device.path, device.identity) + " cannot be opened (" + trouble +
                       "); install the udev rule, or " + words_.let_it_open;
        return false;
    }
    heard_.add(std::move(opened));
    return true;
}

SourceStatus DeviceSource::nothing_plugged_in() const {
    const std::string who = in_words(words_.kind, selector_);
    if (!left_alone_.empty())
        return {Presence::Absent,
                who + ": " + left_alone_ + " is heard by hid: already; name another one, or leave hid: or evdev: away"};
    return {Presence::Absent,
            who + (selector_ == DeviceSelector{} ? " with buttons" : "") + " is not plugged in; " + words_.plug_in};
}

SourceStatus DeviceSource::look() {
    const std::vector<FoundDevice> found = candidates();
    if (found.empty() || !found.front().may_be_first) return nothing_plugged_in();
    std::string who;
    for (const FoundDevice& one : found)
        if (goes_with(one, found.front())) who += (who.empty() ? "" : ", ") + describe(one.path, one.identity);
    return {Presence::Present, who};
}

void DeviceSource::look_for(Instant now) {
    look_at_ = now + kLookEvery;
    refused_.clear();
    const std::vector<FoundDevice> found = candidates();
    const auto first = std::find_if(found.begin(), found.end(),
                                    [&](const FoundDevice& one) { return one.may_be_first && open(one, now); });
    if (first == found.end()) return;
    std::vector<std::string> unwanted;  // what is not there any more says so itself, and then counts as unplugged
    for (const FoundDevice& one : found)
        if (!goes_with(one, *first) || !open(one, now)) unwanted.push_back(one.path);
    heard_.leave(unwanted, now);
    unplugged_at_.reset();
}

void DeviceSource::tell(Instant now) {
    const bool has_just_gone = unplugged_at_ && now - *unplugged_at_ < kLookEvery;  // its node may outlive it a little
    if (!heard_.is_empty())
        status_ = {Presence::Present, heard_.description() + (refused_.empty() ? "" : "; " + refused_)};
    else if (!refused_.empty() && !has_just_gone)
        status_ = {Presence::Absent, refused_};
    else if (unplugged_at_ && left_alone_.empty())
        status_ = {Presence::Absent,
                   in_words(words_.kind, selector_) + " was unplugged; plug it in again (looked for every second)"};
    else
        status_ = nothing_plugged_in();
}

void DeviceSource::leave_alone(Instant now) {
    std::vector<std::string> paths;
    for (const auto& device : heard_.devices())
        if (is_left_alone(device->identity())) paths.push_back(device->path());
    heard_.leave(paths, now);
}

std::vector<ButtonEdge> DeviceSource::poll(Instant now) {
    const std::size_t at_first = heard_.count();
    leave_alone(now);
    if (take_news() || heard_.count() != at_first || !look_at_ || now >= *look_at_) {
        look_for(now);
        tell(now);
    }
    const std::size_t before = heard_.count();
    std::vector<ButtonEdge> edges = heard_.poll(now);
    if (heard_.count() == before) return edges;
    look_at_ = now;  // it may be back already
    if (heard_.is_empty()) unplugged_at_ = now;
    tell(now);
    return edges;
}

}  // namespace quadrat::firmware_io
