// SPDX-License-Identifier: Apache-2.0
#include "display/pacing.hpp"

#include <algorithm>

namespace quadrat::display {
namespace {

constexpr int kLate = 8;
constexpr int kTooLate = 3 * kLate;  // three late frames close together
constexpr int kTrusted = 3600;       // frames in time: a minute of them
constexpr Pacing::Instant kFirst = std::chrono::seconds{5};
constexpr Pacing::Instant kLongest = std::chrono::minutes{10};

}  // namespace

void Pacing::shown(Instant at, Instant period) {
    const Instant took = last_ ? at - *last_ : period;
    const bool is_late = took > period + period / 2;
    const bool was_due_ahead = is_late && took <= 2 * period + period / 2;
    last_ = at;
    if (!waits(at)) return;
    lateness_ = was_due_ahead ? kTooLate : is_late ? lateness_ + kLate : std::max(0, lateness_ - 1);
    in_time_ = is_late ? 0 : in_time_ + 1;
    if (in_time_ >= kTrusted) ahead_for_ = kFirst;
    if (lateness_ < kTooLate) return;
    lateness_ = in_time_ = 0;
    ahead_until_ = at + ahead_for_;
    ahead_for_ = std::min(2 * ahead_for_, kLongest);
}

}  // namespace quadrat::display
