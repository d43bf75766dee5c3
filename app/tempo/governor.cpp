// SPDX-License-Identifier: Apache-2.0
#include "tempo/governor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "tempo/frame_record.hpp"

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr float kOneMore = 1.12F;  // of the level: too little to be seen
constexpr float kMuchMore = 1.4F;  // far from what it could be: seen, and welcome
constexpr auto kSettling = 400ms;  // until a change can be judged
constexpr auto kBlame = 5s;        // lateness so soon after a raise is the raise's
constexpr auto kLongestPatience = std::chrono::nanoseconds{10min};
constexpr auto kHopeless = 3s;  // late with the least detail: a frame in one period more
constexpr auto kLongestRough = std::chrono::nanoseconds{2h};
constexpr float kLessAtOnce = 0.6F;  // of the level, where a frame takes one period again
constexpr float kGrowing = 0.4F;
constexpr float kLeastGrowing = 0.12F;
constexpr float kGrowingRises = 0.3F;  // octaves a second
constexpr int kFirstFrames = 6;        // of other landscapes: all is drawn anew, and brought to the GPU's memory
constexpr float kWaitTakes = 0.5F;     // a wait, of what is drawn while landscapes grow
constexpr float kSofterFrom = 0.3F;    // level
constexpr float kRoomShare = 0.95F;    // of the frames must have had room before more is tried
constexpr float kLeastRoom = 0.5F;
constexpr float kLateTakes = 0.85F;     // a late frame, of that room
constexpr float kLateTakesNow = 0.95F;  // of the level
constexpr float kLeastByOnes = 0.8F;    // of the level that was chosen last
constexpr float kRoomGrows = 0.0018F;   // octaves a second: it comes back within minutes
constexpr int kHiccup = 3;              // times as long as it was meant to take: no twentieth of detail saves that
constexpr float kMuchRoom = 0.6F;       // of that room: a frame drawn so early leaves room for much more detail

const char* in_words(int periods) {
    constexpr std::array<const char*, 5> kWords{"none", "one", "two", "three", "four"};
    return kWords[static_cast<std::size_t>(periods)];
}

float seconds(std::chrono::nanoseconds t) { return std::chrono::duration<float>(t).count(); }

}  // namespace

float alpha_for(float level) { return level >= kSofterFrom ? level : std::sqrt(level * kSofterFrom); }

float scale_for(float level) {
    constexpr float kSmallest = 0.75F;
    if (level >= kSofterFrom) return 1;
    const float share = std::log(level / kSofterFrom) / std::log(GovernorOptions::kLeast / kSofterFrom);
    return std::max(std::pow(kSmallest, share), kSmallest);
}

DetailGovernor::DetailGovernor(const GovernorOptions& options)
    : most_(options.most),
      target_(std::clamp(options.start, std::min(GovernorOptions::kLeast, options.most), options.most)),
      shown_(target_),
      growing_share_(kGrowing),
      periods_(options.periods),
      samples_(options.samples),
      most_samples_(options.samples) {}

void DetailGovernor::follow(float most) {
    if (most == most_) return;
    most_ = most;
    target_ = std::min(target_, most);
    patience_ = 4s;
}

void DetailGovernor::allow_samples(int most) {
    most_samples_ = most;
    samples_ = std::min(samples_, most);
}

void DetailGovernor::other_landscapes(Instant now) {
    first_frames_left_ = kFirstFrames;
    const bool is_possible = has_room_for_smooth_edges_ && samples_ < most_samples_ && now >= rough_until_;
    if (!is_possible) return;
    samples_ = most_samples_;
    has_room_for_smooth_edges_ = false;
    reason_ = fmt::format("detail {:.2f}: in time, with much room: edges are smooth from now on", target_);
}

// Never soon again, and each time it was wrong for twice as long.
void DetailGovernor::give_up_smooth_edges(const FrameTold& told) {
    samples_ = 1;
    rough_until_ = told.now + rough_for_;
    rough_for_ = std::min(2 * rough_for_, kLongestRough);
    say("late with smooth edges: without them", target_, told);
    begin_anew(told.now);
}

void DetailGovernor::kept_waiting() {
    if (growing_share_ <= kLeastGrowing) return;
    growing_share_ = std::max(growing_share_ * kWaitTakes, kLeastGrowing);
    lower_in_advance();
    reason_ = fmt::format("detail {:.2f} while landscapes grow: a visitor waited for them", target_ * growing_share_);
}

// What is late then is late for what comes, not for how finely it is drawn: the less is drawn of the next at first.
bool DetailGovernor::is_unsettled(const FrameTold& told) const { return told.is_growing || first_frames_left_ > 0; }

// A frame of several periods among others in time: something else took the machine, or the driver its time.
bool DetailGovernor::is_hiccup(const FrameTold& told) const {
    return frames_since_hiccup_ >= kAlone && told.took >= kHiccup * told.period * periods_ &&
           (late_ << (kWindow - kAlone)).none();
}

void DetailGovernor::note_lateness(const FrameTold& told) {
    const bool was_late = is_late(told.took, told.period, periods_);
    const bool is_counted = was_late && !is_hiccup(told);
    frames_since_hiccup_ = was_late && !is_counted ? 0 : std::min(frames_since_hiccup_ + 1, kAlone);
    late_ <<= 1U;
    late_[0] = is_counted;
    if (!is_counted) return;
    const auto at = std::ranges::upper_bound(late_took_, told.took, std::ranges::greater{});
    if (at == late_took_.end()) return;
    std::move_backward(at, late_took_.end() - 1, late_took_.end());
    *at = told.took;
}

void DetailGovernor::frame(const FrameTold& told) {
    if (!last_now_) begin_anew(told.now);
    const bool is_another_screens = follows_screen(told);
    glide(told);
    if (is_another_screens) return;  // it was begun with the time it had before
    note_lateness(told);
    if (late_[0]) {
        begin_calm(told.now);
        room_ = std::max(room_ * kLateTakes, kLeastRoom);
        if (told.share_of_frame_time_used > room_ && told.took < kHiccup * told.period * periods_) yield_a_little(told);
    }
    ++frames_calm_;
    first_frames_left_ = std::max(first_frames_left_ - 1, 0);
    // What it would have used with all the detail that is aimed at: about half of a frame's time follows the level.
    const float whole = told.share_of_frame_time_used * std::sqrt(std::max(target_ / level(), 1.0F));
    frames_with_room_ += whole <= room_;
    frames_with_much_room_ += whole <= kMuchRoom * room_;
    if (late_[0])
        give_way(told);
    else
        try_more(told);
    if (periods_ > 1) look_back(told);
}

// Two periods of one screen are one of another.
bool DetailGovernor::follows_screen(const FrameTold& told) {
    const Instant before = std::exchange(period_, told.period);
    if (periods_ == 1 || before.count() == 0 || 2 * told.period < 3 * before) return false;
    change_periods(1, told.now);
    reason_ = fmt::format("detail {:.2f}: the screen asks for frames more seldom: one in each of its periods", target_);
    begin_anew(told.now);
    return true;
}

// Down within a tenth of a second, up over several.
void DetailGovernor::glide(const FrameTold& told) {
    const float passed_s = std::min(seconds(told.now - last_now_.value_or(told.now)), 0.25F);
    last_now_ = told.now;
    const float ratio = target_ / shown_;
    shown_ *= std::clamp(ratio, std::exp2(-7.0F * passed_s), std::exp2(0.4F * passed_s));
    is_growing_ = told.is_growing;
    const float back = std::exp2(kRoomGrows * passed_s);
    room_ = std::min(room_ * back, kRoom);
    // Where there is much room beside what grows, it need not be less.
    const bool has_room =
        is_growing_ && told.share_of_frame_time_used < kMuchRoom * room_ && !is_late(told.took, told.period, periods_);
    growing_share_ = has_room ? std::min(growing_share_ * std::exp2(kGrowingRises * passed_s), 1.0F)
                              : std::max(std::min(growing_share_ * back, kGrowing), growing_share_);
    recovered_ = is_growing_ ? growing_share_ : std::min(recovered_ * std::exp2(0.4F * passed_s), 1.0F);
}

// One late frame of many costs what cannot be seen, where it was late for what was drawn. Many together are for
// give_way(): until then no more than this is taken.
void DetailGovernor::yield_a_little(const FrameTold& told) {
    const float before = target_;
    if (is_unsettled(told)) {
        growing_share_ = std::max(growing_share_ * kLateTakes, kLeastGrowing);
    } else if (target_ > GovernorOptions::kLeast && samples_ == 1) {
        target_ = std::min(target_, std::max({target_ * kLateTakesNow, least_by_ones_, GovernorOptions::kLeast}));
        if (target_ < before) say("late", before, told);
        if (target_ <= GovernorOptions::kLeast) at_least_since_ = told.now;
    }
}

void DetailGovernor::give_way(const FrameTold& told) {
    if (late_.count() < kTooManyLate || told.now - changed_at_ < kSettling) return;
    has_room_for_smooth_edges_ = false;
    if (samples_ > 1 && told.share_of_frame_time_used > room_) return give_up_smooth_edges(told);
    const float before = target_;
    const bool are_first_frames = !told.is_growing && is_unsettled(told);
    if (are_first_frames && growing_share_ <= kLeastGrowing) return;
    if (is_unsettled(told) && growing_share_ > kLeastGrowing) {
        // Another generation will grow in a minute: that is its share, not the picture's.
        growing_share_ = std::max(0.8F * growing_share_, kLeastGrowing);
        say("late while landscapes grow", before, told);
    } else if (target_ > GovernorOptions::kLeast) {
        const float in_time = seconds(told.period * periods_) / seconds(late_took_.back());
        target_ = std::max(target_ * std::clamp(in_time, 0.5F, 0.85F), GovernorOptions::kLeast);
        if (raised_at_ && told.now - *raised_at_ < kBlame) {
            target_ = std::min(target_, before_raise_);
            patience_ = std::min(2 * patience_, kLongestPatience);
        }
        raised_at_.reset();
        say("late", before, told);
    } else if (periods_ < GovernorOptions::kMostPeriods && told.now - at_least_since_ > kHopeless) {
        change_periods(periods_ + 1, told.now);
        say(fmt::format("late with the least detail: from now on a frame in {} of the screen's periods",
                        in_words(periods_)),
            before, told);
    } else {
        return;
    }
    if (before > GovernorOptions::kLeast) at_least_since_ = told.now;
    begin_anew(told.now);
}

void DetailGovernor::try_more(const FrameTold& told) {
    if (told.is_growing || told.now - calm_since_ < patience_) return;
    const auto are_most = [this](int frames) {
        return static_cast<float>(frames) >= kRoomShare * static_cast<float>(frames_calm_);
    };
    const bool had_room = are_most(frames_with_room_);
    const bool had_much_room = are_most(frames_with_much_room_);
    begin_calm(told.now);
    // Rather smooth than fine.
    if (periods_ > 1 && had_much_room && full_rate_probe_.watch(told.now)) return;
    has_room_for_smooth_edges_ = had_much_room && target_ >= most_ && periods_ == 1;
    if (!had_room || target_ >= most_) return;
    before_raise_ = target_;
    target_ = std::min(target_ * (had_much_room ? kMuchMore : kOneMore), most_);
    raised_at_ = told.now;
    least_by_ones_ = kLeastByOnes * target_;
    say(had_much_room ? "in time, with much room" : "in time, with room", before_raise_, told);
}

// To a frame in one period less.
void DetailGovernor::look_back(const FrameTold& told) {
    const float fewer = static_cast<float>(periods_ - 1);
    full_rate_probe_.frame(told.now, told.share_of_frame_time_used * static_cast<float>(periods_) / fewer,
                           told.is_growing);
    if (!full_rate_probe_.is_open(told.now)) return;
    change_periods(periods_ - 1, told.now);
    target_ = std::max(kLessAtOnce * target_, GovernorOptions::kLeast);
    reason_ = fmt::format("detail {:.2f}: drawn so early: from now on a frame in {} of the screen's periods", target_,
                          periods_ == 1 ? "each" : in_words(periods_));
    begin_anew(told.now);
}

void DetailGovernor::change_periods(int periods, Instant now) {
    periods_ = periods;
    periods > 1 ? full_rate_probe_.given_up(now) : full_rate_probe_.taken(now);
    room_ = kRoom;
    growing_share_ = kGrowing;
    at_least_since_ = now;
}

void DetailGovernor::begin_anew(Instant now) {
    late_.reset();
    late_took_ = {};
    changed_at_ = now;
    least_by_ones_ = kLeastByOnes * target_;
    begin_calm(now);
}

void DetailGovernor::begin_calm(Instant now) {
    calm_since_ = now;
    frames_calm_ = frames_with_room_ = frames_with_much_room_ = 0;
}

void DetailGovernor::say(std::string_view why, float before, const FrameTold& told) {
    const auto ms = [](Instant t) { return 1e3F * seconds(t); };
    if (late_.any())
        reason_ = fmt::format("detail {:.2f}, was {:.2f}: {} of {} frames {} ({:.0f} ms for {:.0f})", target_, before,
                              late_.count(), kWindow, why, ms(late_took_.front()), ms(told.period * periods_));
    else
        reason_ = fmt::format("detail {:.2f}, was {:.2f}: {} for {:.0f} s", target_, before, why, seconds(patience_));
}

std::optional<std::string> DetailGovernor::take_reason() {
    if (reason_.empty()) return std::nullopt;
    return std::exchange(reason_, {});
}

}  // namespace quadrat::tempo
