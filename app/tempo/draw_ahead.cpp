// SPDX-License-Identifier: Apache-2.0
#include "tempo/draw_ahead.hpp"

#include <algorithm>

namespace quadrat::tempo {
namespace {

constexpr int kLate = 8;
constexpr int kTooLate = 3 * kLate;  // three late frames close together
constexpr int kTrusted = 3600;       // frames in time: a minute of them at 60 Hz
constexpr nanoseconds kFirst = std::chrono::seconds{5};
constexpr nanoseconds kLongest = std::chrono::minutes{10};

}  // namespace

void DrawAhead::shown(const FrameRecord& record) {
    const bool was_late = is_late(record);
    const bool was_due_ahead = was_late && took(record) <= 2 * frame_time(record) + record.period / 2;
    if (!waits(record.shown)) return;
    lateness_ = was_due_ahead ? kTooLate : was_late ? lateness_ + kLate : std::max(0, lateness_ - 1);
    in_time_ = was_late ? 0 : in_time_ + 1;
    if (in_time_ >= kTrusted) ahead_for_ = kFirst;
    if (lateness_ < kTooLate) return;
    lateness_ = in_time_ = 0;
    ahead_until_ = record.shown + ahead_for_;
    ahead_for_ = std::min(2 * ahead_for_, kLongest);
}

}  // namespace quadrat::tempo
