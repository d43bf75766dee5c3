// SPDX-License-Identifier: Apache-2.0
#include "tempo/tempo.hpp"

#include <utility>

namespace quadrat::tempo {
namespace {

constexpr nanoseconds kUsualPeriod{16'666'667};         // where the display has none of its own
constexpr nanoseconds kAway = std::chrono::seconds{1};  // so long between frames, and the screen was away
constexpr int kFramesOfAWait = 3;                       // two frames nobody takes for a wait

// The share of its frame's time that it took until it was drawn; 1: it had no room left, or was not drawn in time.
float share_of_frame_time_used(const FrameRecord& record) {
    if (!record.drawn) return 1;
    const float share = std::chrono::duration<float>(*record.drawn - record.begun) / frame_time(record);
    return share > DetailGovernor::kRoom ? 1 : share;
}

}  // namespace

Tempo::Tempo(const TempoOptions& options) : governing_(options.governing), governor_(options.detail) {
    if (options.budget) budget_.emplace(*options.budget, options.detail.most);
    plan_.fineness = {options.detail.most, 1};
    plan_.level = options.detail.most;
    plan_.uploads = uploads_.next(kUsualPeriod);
}

void Tempo::begin_anew(const GovernorOptions& detail) { governor_ = DetailGovernor(detail); }

const Plan& Tempo::next(std::span<const FrameRecord> shown, const Circumstances& now) {
    uploads_.used(plan_.uploads, now.were_uploads_awaited);
    governor_.follow(now.most_level);
    if (now.most_samples > 0) governor_.allow_samples(now.most_samples);
    for (const FrameRecord& record : shown) judge(record, now);
    was_slowed_ = now.is_growing || now.is_waited_for;
    notice_landscapes(now);
    plan_detail(now);
    plan_hand_over(now);
    return plan_;
}

void Tempo::judge(FrameRecord record, const Circumstances& now) {
    last_shown_ = record;
    ahead_.shown(record);
    if (record.period.count() == 0) record.period = kUsualPeriod;
    uploads_.drew(record.drawn.value_or(record.handed_over) - record.drawing_since);
    const bool is_comparable = record.shown_before && took(record) <= kAway;
    // What is left of the cadence before says nothing about this one.
    if (governing_ == Governing::Fixed || !now.is_judged || !is_comparable ||
        record.meant_periods != governor_.periods())
        return;
    governor_.frame(
        {record.shown.time_since_epoch(), took(record), record.period, share_of_frame_time_used(record), was_slowed_});
}

// Less is drawn of the first frame of other landscapes, and of the first while some grow, not only once one was late.
void Tempo::notice_landscapes(const Circumstances& now) {
    const bool begins_to_grow = !std::exchange(was_growing_, now.is_growing) && now.is_growing;
    const bool is_first = std::exchange(act_, now.act) != now.act;
    if (is_first) governor_.other_landscapes(now.now.time_since_epoch());
    if (is_first || begins_to_grow) governor_.lower_in_advance();
    frames_waited_ = now.is_waited_for ? frames_waited_ + 1 : 0;
    if (frames_waited_ == kFramesOfAWait) governor_.kept_waiting();
}

void Tempo::plan_detail(const Circumstances& now) {
    plan_.reason.clear();
    plan_.fineness = {now.most_level, 1};
    plan_.level = now.most_level;
    plan_.periods = 1;
    plan_.samples = 1;
    if (governing_ == Governing::ByFrames) {
        plan_.level = governor_.level();
        plan_.fineness = {alpha_for(plan_.level), scale_for(plan_.level)};
        plan_.periods = governor_.periods();
        plan_.samples = governor_.samples();
        plan_.reason = governor_.take_reason().value_or("");
    }
    if (!budget_) return;
    if (now.triangles > 0) budget_->drew(now.triangles);
    plan_.fineness = budget_->fineness(now.pixels);
    plan_.level = plan_.fineness.alpha;
}

void Tempo::plan_hand_over(const Circumstances& now) {
    const nanoseconds period = now.period.count() > 0 ? now.period : kUsualPeriod;
    plan_.uploads = uploads_.next(period * plan_.periods);
    plan_.then = ahead_.waits(now.now) ? HandOver::Then::Wait : HandOver::Then::Ahead;
    plan_.hand_over_at.reset();
    if (plan_.periods == 1 || !last_shown_ || now.period.count() == 0) return;
    plan_.hand_over_at = hand_over_at({period, plan_.periods, last_shown_->shown, now.in_flight_since});
}

}  // namespace quadrat::tempo
