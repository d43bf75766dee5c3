// SPDX-License-Identifier: Apache-2.0
#include "tempo/full_rate_probe.hpp"

#include <algorithm>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr auto kWatched = 1min;
constexpr auto kWatchedIdle = 10min;  // where nothing grew meanwhile
constexpr float kEnough = 0.84F;      // of one period: what the governor calls much room in two
constexpr int kFewOf = 400;           // frames: one of so many may have had no room
constexpr auto kFirstPause = std::chrono::nanoseconds{1min};
constexpr auto kLongestPause = std::chrono::nanoseconds{2h};
constexpr auto kKept = 1h;  // so long in one period: whatever it was has passed

}  // namespace

bool FullRateProbe::watch(Instant now) {
    if (is_watching_) return true;
    if (now < not_before_) return false;
    is_watching_ = true;
    was_growing_ = false;
    frames_ = without_room_ = 0;
    since_ = now;
    return true;
}

void FullRateProbe::frame(Instant now, float share_used, bool is_growing) {
    if (!is_watching_) return;
    ++frames_;
    without_room_ += share_used > kEnough;
    was_growing_ |= is_growing;
    if (without_room_ <= 1 + frames_ / kFewOf) return;
    is_watching_ = false;
    not_before_ = now + pause_;
}

bool FullRateProbe::is_open(Instant now) const {
    return is_watching_ && now - since_ >= (was_growing_ ? Instant{kWatched} : Instant{kWatchedIdle});
}

void FullRateProbe::taken(Instant now) {
    is_watching_ = false;
    taken_at_ = now;
}

void FullRateProbe::given_up(Instant now) {
    if (!taken_at_) return;
    pause_ = now - *taken_at_ > kKept ? kFirstPause : std::min(2 * pause_, kLongestPause);
    not_before_ = now + pause_;
}

}  // namespace quadrat::tempo
