// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/hid_buttons.hpp"

#include <algorithm>
#include <utility>

#include "firmware-io/text.hpp"

namespace quadrat::firmware_io::hid {
namespace {

using namespace std::chrono_literals;

constexpr Instant kRetryEvery = 1s;
constexpr Instant kSettling = 200ms;
constexpr int kMostReportsPerPoll = 256;        // four times the kernel's ring: a flood must not keep the frame waiting
constexpr int kTaught = 100;                    // likelier than any that was not
constexpr int kTaughtHere = 101;                // and likelier still than its equal in another port
constexpr std::size_t kLongestReport = 16'385;  // with its report ID

// " 0079:0006"
std::string to_string(std::uint16_t vendor, std::uint16_t product) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text(10, ' ');
    for (std::size_t i = 0; i < 4; ++i) {
        text[1 + i] = kDigits[vendor >> (12 - 4 * i) & 0xfu];
        text[6 + i] = kDigits[product >> (12 - 4 * i) & 0xfu];
    }
    text[5] = ':';
    return text;
}

std::string describe(const HidDeviceFacts& device) {
    const HidIdentity& identity = device.identity;
    return device.path + " (" + identity.name + to_string(identity.vendor, identity.product) + ")";
}

}  // namespace

bool is_meant(const HidSelector& selector, const HidDeviceFacts& device) {
    const std::string& port = device.identity.port;
    const bool is_port =
        selector.port.empty() ||
        (port.starts_with(selector.port) && (port.size() == selector.port.size() || port[selector.port.size()] == '/'));
    return is_port && (selector.path.empty() || selector.path == device.path) &&
           selector.vendor.value_or(device.identity.vendor) == device.identity.vendor &&
           selector.product.value_or(device.identity.product) == device.identity.product;
}

std::string to_string(const HidSelector& selector) {
    std::string text = "HID device";
    if (selector.vendor && selector.product) text += to_string(*selector.vendor, *selector.product);
    if (!selector.path.empty()) text += " " + selector.path;
    if (!selector.port.empty()) text += " at " + selector.port;
    return text;
}

HidButtons::HidButtons(std::unique_ptr<HidHost> host, HidSelector selector, DebounceOptions debounce,
                       std::vector<HidMapping> mappings)
    : host_{std::move(host)}, selector_{std::move(selector)}, mappings_{std::move(mappings)}, debouncer_{debounce} {
    status_ = {Presence::Absent, to_string(selector_) + " has not been looked for yet"};
}

std::vector<HidButtons::Candidate> HidButtons::candidates() {
    std::vector<Candidate> found;
    for (HidDeviceFacts& device : host_->devices()) {
        if (!is_meant(selector_, device)) continue;
        HidLayout layout = parse_descriptor(device.descriptor);
        const HidMapping* mapping = mapping_of(mappings_, device.identity);
        Bindings bindings = mapping != nullptr ? mapping->bindings : Bindings{};
        std::erase_if(bindings, [&](const Binding& binding) { return !can_send(layout, binding.signal); });
        const bool is_here = mapping != nullptr && mapping->port == one_word(device.identity.port) &&
                             mapping->serial == one_word(device.identity.serial);
        const int is_likely = bindings.empty() ? likelihood(layout) : is_here ? kTaughtHere : kTaught;
        if (bindings.empty()) bindings = default_bindings(layout);
        if (!bindings.empty()) found.push_back({std::move(device), std::move(layout), std::move(bindings), is_likely});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.likelihood > b.likelihood; });
    return found;
}

bool HidButtons::open(Candidate& candidate, Instant now) {
    std::string trouble;
    stream_ = host_->open(candidate.device.path, trouble);
    if (!stream_) {
        status_ = {Presence::Absent, describe(candidate.device) + " cannot be opened (" + trouble +
                                         "); install the udev rule, or give the user read and write access"};
        return false;
    }
    reader_ = ReportReader{std::move(candidate.layout)};
    bindings_ = std::move(candidate.bindings);
    opened_at_ = now;
    status_ = {Presence::Present, describe(candidate.device)};
    return true;
}

SourceStatus HidButtons::nothing_plugged_in() const {
    return {Presence::Absent, to_string(selector_) + (selector_ == HidSelector{} ? " with buttons" : "") +
                                  " is not plugged in; plug it in (a gamepad must be switched to D-input or PC mode)"};
}

SourceStatus HidButtons::look() {
    const std::vector<Candidate> found = candidates();
    if (found.empty()) return nothing_plugged_in();
    return {Presence::Present, describe(found.front().device)};
}

void HidButtons::open(Instant now) {
    if (retry_at_ && now < *retry_at_) return;
    retry_at_ = now + kRetryEvery;
    status_ = nothing_plugged_in();
    for (Candidate& candidate : candidates())
        if (open(candidate, now)) return;
}

void HidButtons::lose(Instant now) {
    stream_.reset();
    debouncer_.lost(now);
    retry_at_ = now + kRetryEvery;
    status_ = {Presence::Absent, to_string(selector_) + " was unplugged; plug it in again (looked for every second)"};
}

// Takes over what the reports so far say is pressed.
void HidButtons::follow(Instant now) {
    const std::vector<HidSignal> pressed = reader_.pressed();
    std::array<bool, kButtons.size()> is_closed{};
    for (const Binding& binding : bindings_)
        if (std::binary_search(pressed.begin(), pressed.end(), binding.signal))
            is_closed[index_of(binding.button)] = true;
    for (const Button button : kButtons) {
        if (now - opened_at_ < kSettling)
            debouncer_.found(button, is_closed[index_of(button)], now);
        else
            debouncer_.contact(button, is_closed[index_of(button)], now);
    }
}

std::vector<ButtonEdge> HidButtons::poll(Instant now) {
    if (!stream_) open(now);
    std::array<std::uint8_t, kLongestReport> report;
    for (int i = 0; stream_ && i < kMostReportsPerPoll; ++i) {
        const std::ptrdiff_t length = stream_->read(report);
        if (length == HidStream::kNothing) break;
        if (length < 0) {
            lose(now);
        } else {
            reader_.read(std::span{report}.first(static_cast<std::size_t>(length)));
            follow(now);
        }
    }
    return debouncer_.take(now);
}

}  // namespace quadrat::firmware_io::hid
