// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/hid/hid_interface.hpp"

#include <algorithm>
#include <utility>

namespace quadrat::firmware_io::hid {
namespace {

using namespace std::chrono_literals;

constexpr Instant kSettling = 200ms;
constexpr int kMostReportsPerPoll = 256;        // four times the kernel's ring: a flood must not keep the frame waiting
constexpr std::size_t kLongestReport = 16'385;  // with its report ID

}  // namespace

HidInterface::HidInterface(Opened opened, DebounceOptions debounce, std::shared_ptr<HeardBoards> boards)
    : HeardDevice{opened.device.path, opened.device.identity, debounce},
      stream_{std::move(opened.stream)},
      reader_{std::move(opened.layout)},
      bindings_{std::move(opened.bindings)},
      opened_at_{opened.at},
      boards_{std::move(boards)} {
    if (boards_) boards_->begin(board_of(identity()));
}

HidInterface::~HidInterface() {
    if (boards_) boards_->end(board_of(identity()));
}

// Takes over what the reports so far say is pressed.
void HidInterface::follow(Instant now) {
    const std::vector<HidSignal> pressed = reader_.pressed();
    std::array<bool, kButtons.size()> is_closed{};
    for (const Binding& binding : bindings_)
        if (std::binary_search(pressed.begin(), pressed.end(), binding.signal))
            is_closed[index_of(binding.button)] = true;
    for (const Button button : kButtons) {
        if (now - opened_at_ < kSettling)
            debouncer().found(button, is_closed[index_of(button)], now);
        else
            debouncer().contact(button, is_closed[index_of(button)], now);
    }
}

HeardDevice::Plug HidInterface::hear(Instant now) {
    std::array<std::uint8_t, kLongestReport> report;
    for (int i = 0; i < kMostReportsPerPoll; ++i) {
        const std::ptrdiff_t length = stream_->read(report);
        if (length == HidStream::kNothing) return Plug::In;
        if (length < 0) return Plug::Gone;
        reader_.read(std::span{report}.first(static_cast<std::size_t>(length)));
        follow(now);
    }
    return Plug::In;
}

}  // namespace quadrat::firmware_io::hid
