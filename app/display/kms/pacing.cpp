// SPDX-License-Identifier: Apache-2.0
#include "display/kms/pacing.hpp"

#include <algorithm>

namespace quadrat::display {
namespace {

constexpr int kLate = 8;
constexpr int kTooLate = 3 * kLate;  // three late frames close together; one is a hiccup
constexpr int kTrusted = 3600;       // frames in time: a minute of them
constexpr Pacing::Instant kFirst = std::chrono::seconds{5};
constexpr Pacing::Instant kLongest = std::chrono::minutes{10};

}  // namespace

void Pacing::shown(Instant at, Instant period) {
    const bool is_late = last_ && at - *last_ > period + period / 2;
    last_ = at;
    if (!waits(at)) return;
    lateness_ = is_late ? lateness_ + kLate : std::max(0, lateness_ - 1);
    in_time_ = is_late ? 0 : in_time_ + 1;
    if (in_time_ >= kTrusted) ahead_for_ = kFirst;
    if (lateness_ < kTooLate) return;
    lateness_ = in_time_ = 0;
    ahead_until_ = at + ahead_for_;
    ahead_for_ = std::min(2 * ahead_for_, kLongest);
}

}  // namespace quadrat::display
