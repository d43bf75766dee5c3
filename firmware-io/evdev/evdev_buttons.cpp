// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/evdev/evdev_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/evdev/evdev_device.hpp"

namespace quadrat::firmware_io::evdev {
namespace {

using namespace std::chrono_literals;

constexpr Instant kLookEvery = 1s;

}  // namespace

EvdevButtons::EvdevButtons(std::unique_ptr<EvdevHost> host, EvdevOptions options,
                           std::shared_ptr<const HeardBoards> boards)
    : host_{std::move(host)},
      options_{std::move(options)},
      boards_{std::move(boards)},
      status_{Presence::Absent, in_words("input device", options_.selector) + " has not been looked for yet"} {}

std::vector<EvdevDeviceFacts> EvdevButtons::meant() const {
    const DeviceSelector& selector = options_.selector;
    std::vector<EvdevDeviceFacts> all = host_->devices(), found;
    std::vector<std::string> boards;
    for (const EvdevDeviceFacts& device : all)
        if (is_meant(selector, device.identity, device.path)) boards.push_back(board_of(device.identity));
    for (EvdevDeviceFacts& device : all) {
        const bool is_of_board = !selector.path.empty() && !device.identity.port.empty() &&
                                 std::find(boards.begin(), boards.end(), board_of(device.identity)) != boards.end();
        if (is_of_board || is_meant(selector, device.identity, device.path)) found.push_back(std::move(device));
    }
    return found;
}

std::vector<EvdevButtons::Candidate> EvdevButtons::candidates() {
    std::vector<Candidate> found;
    left_alone_.clear();
    for (EvdevDeviceFacts& device : meant()) {
        Bindings bindings = options_.bindings;
        std::erase_if(bindings, [&](const Binding& binding) { return !can_send(device, binding.signal); });
        const int is_likely = options_.bindings.empty() ? likelihood(device) : bindings.empty() ? 0 : 3;
        if (options_.bindings.empty()) bindings = default_bindings(device);
        if (is_likely == 0) continue;
        if (is_left_alone(device.identity)) {
            left_alone_ = describe(device.path, device.identity);
            continue;
        }
        found.push_back({std::move(device), std::move(bindings), is_likely});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.likelihood > b.likelihood; });
    return found;
}

bool EvdevButtons::may_be_first(const Candidate& one) const {
    return one.likelihood > 1 || options_.selector != DeviceSelector{};
}

bool EvdevButtons::goes_with(const Candidate& other, const Candidate& first) {
    const DeviceIdentity &a = other.device.identity, &b = first.device.identity;
    if (is_pointing(other.device) && !is_pointing(first.device)) return false;
    return a.vendor == b.vendor && a.product == b.product;
}

bool EvdevButtons::open(Candidate& candidate, Instant now) {
    if (heard_.has(candidate.device.path)) return true;
    std::string trouble;
    auto stream = host_->open(candidate.device.path, options_.grab, trouble);
    if (!stream) {
        if (refused_.empty())
            refused_ = describe(candidate.device.path, candidate.device.identity) + " cannot be opened (" + trouble +
                       "); install the udev rule, or stop the program that has it";
        return false;
    }
    heard_.add(std::make_unique<EvdevDevice>(
        EvdevDevice::Opened{candidate.device, std::move(stream), std::move(candidate.bindings), now},
        options_.debounce));
    return true;
}

SourceStatus EvdevButtons::nothing_plugged_in() const {
    if (!left_alone_.empty())
        return {Presence::Absent, in_words("input device", options_.selector) + ": " + left_alone_ +
                                      " is heard by hid: already; name another one, or leave hid: or evdev: away"};
    return {Presence::Absent, in_words("input device", options_.selector) +
                                  (options_.selector == DeviceSelector{} ? " with buttons" : "") +
                                  " is not plugged in; plug it in"};
}

SourceStatus EvdevButtons::look() {
    const std::vector<Candidate> found = candidates();
    if (found.empty() || !may_be_first(found.front())) return nothing_plugged_in();
    std::string who;
    for (const Candidate& one : found)
        if (goes_with(one, found.front()))
            who += (who.empty() ? "" : ", ") + describe(one.device.path, one.device.identity);
    return {Presence::Present, who};
}

// The likeliest that can be opened decides who is heard, whichever was plugged in first.
void EvdevButtons::look_for(Instant now) {
    look_at_ = now + kLookEvery;
    refused_.clear();
    std::vector<Candidate> found = candidates();
    const auto first =
        std::find_if(found.begin(), found.end(), [&](Candidate& one) { return may_be_first(one) && open(one, now); });
    if (first == found.end()) return;
    std::vector<std::string> unwanted;  // what is not there any more says so itself, and then counts as unplugged
    for (Candidate& one : found)
        if (!goes_with(one, *first) || !open(one, now)) unwanted.push_back(one.device.path);
    heard_.leave(unwanted, now);
    unplugged_at_.reset();
}

void EvdevButtons::tell(Instant now) {
    const bool has_just_gone = unplugged_at_ && now - *unplugged_at_ < kLookEvery;  // its node may outlive it a little
    if (!heard_.is_empty())
        status_ = {Presence::Present, heard_.description() + (refused_.empty() ? "" : "; " + refused_)};
    else if (!refused_.empty() && !has_just_gone)
        status_ = {Presence::Absent, refused_};
    else if (unplugged_at_ && left_alone_.empty())
        status_ = {Presence::Absent, in_words("input device", options_.selector) +
                                         " was unplugged; plug it in again (looked for every second)"};
    else
        status_ = nothing_plugged_in();
}

void EvdevButtons::leave_alone(Instant now) {
    std::vector<std::string> paths;
    for (const auto& device : heard_.devices())
        if (is_left_alone(device->identity())) paths.push_back(device->path());
    heard_.leave(paths, now);
}

std::vector<ButtonEdge> EvdevButtons::poll(Instant now) {
    const std::size_t at_first = heard_.count();
    leave_alone(now);
    if (host_->take_news() || heard_.count() != at_first || !look_at_ || now >= *look_at_) {
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

}  // namespace quadrat::firmware_io::evdev
