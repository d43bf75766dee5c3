// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/hid_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/hid/hid_interface.hpp"
#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::hid {
namespace {

using namespace std::chrono_literals;

constexpr Instant kLookEvery = 1s;
constexpr int kTaught = 100;      // likelier than any that was not
constexpr int kTaughtHere = 101;  // and likelier still than its equal in another port

}  // namespace

HidButtons::HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce,
                       std::vector<HidMapping> mappings, std::shared_ptr<HeardBoards> boards)
    : host_{std::move(host)},
      selector_{std::move(selector)},
      debounce_{debounce},
      mappings_{std::move(mappings)},
      boards_{std::move(boards)},
      status_{Presence::Absent, in_words("HID device", selector_) + " has not been looked for yet"} {}

HidButtons::~HidButtons() = default;

std::vector<HidDeviceFacts> HidButtons::meant() const {
    std::vector<HidDeviceFacts> all = host_->devices(), found;
    std::vector<std::string> boards;
    for (const HidDeviceFacts& device : all)
        if (is_meant(selector_, device)) boards.push_back(board_of(device.identity));
    for (HidDeviceFacts& device : all) {
        const bool is_of_board = !selector_.path.empty() && !device.identity.port.empty() &&
                                 std::find(boards.begin(), boards.end(), board_of(device.identity)) != boards.end();
        if (is_of_board || is_meant(selector_, device)) found.push_back(std::move(device));
    }
    return found;
}

std::optional<HidButtons::Candidate> HidButtons::candidate(HidDeviceFacts device) const {
    HidLayout layout = parse_descriptor(device.descriptor);
    const HidMapping* mapping = mapping_of(mappings_, device.identity);
    Bindings bindings = mapping != nullptr ? mapping->bindings : Bindings{};
    std::erase_if(bindings, [&](const Binding& binding) { return !can_send(layout, binding.signal); });
    const bool is_here = mapping != nullptr && mapping->port == one_word(device.identity.port) &&
                         mapping->serial == one_word(device.identity.serial);
    const int is_likely = bindings.empty() ? likelihood(layout) : is_here ? kTaughtHere : kTaught;
    if (bindings.empty()) bindings = default_bindings(layout);
    if (bindings.empty()) return std::nullopt;
    const auto& roles = layout.applications;
    const bool is_mouse = is_likely == 1 && std::find(roles.begin(), roles.end(), kMouse) != roles.end();
    return Candidate{std::move(device), std::move(layout), std::move(bindings), is_likely, is_mouse};
}

std::vector<HidButtons::Candidate> HidButtons::candidates() const {
    std::vector<Candidate> found;
    for (HidDeviceFacts& device : meant())
        if (auto one = candidate(std::move(device))) found.push_back(std::move(*one));
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.likelihood > b.likelihood; });
    return found;
}

bool HidButtons::goes_with(const Candidate& other, const Candidate& first) {
    const HidIdentity &a = other.device.identity, &b = first.device.identity;
    if (other.is_mouse && !first.is_mouse) return false;
    return (a.vendor == b.vendor && a.product == b.product) ||
           (other.likelihood >= kTaught && first.likelihood >= kTaught);
}

bool HidButtons::open(Candidate& candidate, Instant now) {
    if (heard_.has(candidate.device.path)) return true;
    std::string trouble;
    auto stream = host_->open(candidate.device.path, trouble);
    if (!stream) {
        if (refused_.empty())
            refused_ = describe(candidate.device.path, candidate.device.identity) + " cannot be opened (" + trouble +
                       "); install the udev rule, or give the user read and write access";
        return false;
    }
    HidInterface::Opened opened{candidate.device, std::move(stream), std::move(candidate.layout),
                                std::move(candidate.bindings), now};
    heard_.add(std::make_unique<HidInterface>(std::move(opened), debounce_, boards_));
    return true;
}

SourceStatus HidButtons::nothing_plugged_in() const {
    return {Presence::Absent, in_words("HID device", selector_) + (selector_ == HidSelector{} ? " with buttons" : "") +
                                  " is not plugged in; plug it in (a gamepad in X-input mode is heard by evdev:)"};
}

SourceStatus HidButtons::look() {
    const std::vector<Candidate> found = candidates();
    if (found.empty()) return nothing_plugged_in();
    std::string who;
    for (const Candidate& one : found)
        if (goes_with(one, found.front()))
            who += (who.empty() ? "" : ", ") + describe(one.device.path, one.device.identity);
    return {Presence::Present, who};
}

// The likeliest that can be opened decides who is heard, whichever was plugged in first.
void HidButtons::look_for(Instant now) {
    look_at_ = now + kLookEvery;
    refused_.clear();
    std::vector<Candidate> found = candidates();
    const auto first = std::find_if(found.begin(), found.end(), [&](Candidate& one) { return open(one, now); });
    if (first == found.end()) return;
    std::vector<std::string> unwanted;  // what is not there any more says so itself, and then counts as unplugged
    for (Candidate& one : found)
        if (!goes_with(one, *first) || !open(one, now)) unwanted.push_back(one.device.path);
    heard_.leave(unwanted, now);
    unplugged_at_.reset();
}

void HidButtons::tell(Instant now) {
    const bool has_just_gone = unplugged_at_ && now - *unplugged_at_ < kLookEvery;  // its node may outlive it a little
    if (!heard_.is_empty())
        status_ = {Presence::Present, heard_.description() + (refused_.empty() ? "" : "; " + refused_)};
    else if (!refused_.empty() && !has_just_gone)
        status_ = {Presence::Absent, refused_};
    else if (unplugged_at_)
        status_ = {Presence::Absent,
                   in_words("HID device", selector_) + " was unplugged; plug it in again (looked for every second)"};
    else
        status_ = nothing_plugged_in();
}

std::vector<ButtonEdge> HidButtons::poll(Instant now) {
    if (host_->take_news() || !look_at_ || now >= *look_at_) {
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

}  // namespace quadrat::firmware_io::hid
