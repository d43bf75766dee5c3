// SPDX-License-Identifier: Apache-2.0
// The governor on machines whose speed is known: what they take for a frame is a part that is always there and one that
// follows the detail, and a screen shows what is ready at its next period.
#include "tempo/governor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/seed.hpp"
#include "tempo/memory.hpp"

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using Instant = DetailGovernor::Instant;

constexpr Instant kPeriod{16'666'667};

struct Machine {
    float always_ms = 5;
    float for_detail_ms = 20;  // at alpha 1
    float noise = 0.04F;
    base::RandomStream random{base::Seed{7}};

    Instant work(float alpha, float slower) {
        const float ms = (always_ms + for_detail_ms * alpha) * slower * (1 + noise * (2 * random.unit_f() - 1));
        return Instant{static_cast<std::int64_t>(ms * 1e6F)};
    }
};

float used_of(Instant work, const DetailGovernor& governor) {
    const float used = std::chrono::duration<float>(work) / std::chrono::duration<float>(kPeriod * governor.periods());
    return used < DetailGovernor::kRoom ? used : 1;
}

struct Watched {
    int frames = 0;
    int late = 0;
    int turns = 0;  // from more to less or back
    float least = 1e9F;
    float most = 0;
    int longest_run_late = 0;
};

// slower(now): how much longer everything takes; is_growing(now).
template <typename Slower, typename Growing>
Watched watch(DetailGovernor& governor, Machine& machine, Instant from, Instant to, const Slower& slower,
              const Growing& is_growing) {
    Watched seen;
    float settled = governor.settled();
    int direction = 0;
    int run = 0;
    for (Instant now = from; now < to;) {
        const Instant work = machine.work(governor.level(), slower(now));
        const auto periods =
            std::max<std::int64_t>(governor.periods(), (work.count() + kPeriod.count() - 1) / kPeriod.count());
        const Instant took = kPeriod * periods;
        const bool is_late = periods > governor.periods();
        run = is_late ? run + 1 : 0;
        seen.longest_run_late = std::max(seen.longest_run_late, run);
        ++seen.frames;
        seen.late += is_late;
        now += took;
        governor.frame({now, took, kPeriod, used_of(work, governor), is_growing(now)});
        seen.least = std::min(seen.least, governor.level());
        seen.most = std::max(seen.most, governor.level());
        if (governor.settled() == settled) continue;
        const int way = governor.settled() > settled ? 1 : -1;
        seen.turns += direction != 0 && way != direction;
        direction = way;
        settled = governor.settled();
    }
    return seen;
}

const auto kSteady = [](Instant) { return 1.0F; };
const auto kNothingGrows = [](Instant) { return false; };

TEST(Governor, LeavesAFastMachineAlone) {
    DetailGovernor governor({});
    Machine machine{3, 5};
    const Watched seen = watch(governor, machine, 0s, 120s, kSteady, kNothingGrows);
    EXPECT_EQ(seen.late, 0);
    EXPECT_EQ(governor.level(), 1.0F);
    EXPECT_FALSE(governor.take_reason().has_value());
}

TEST(Governor, FindsWhatASlowMachineCanDoAndStaysThere) {
    DetailGovernor governor({});
    Machine machine{5, 30};  // in time up to 0.39
    const Watched finding = watch(governor, machine, 0s, 20s, kSteady, kNothingGrows);
    EXPECT_LT(finding.late, 60);
    const Watched seen = watch(governor, machine, 20s, 20min, kSteady, kNothingGrows);
    EXPECT_LE(seen.late, seen.frames / 1000);
    EXPECT_LE(seen.turns, 4);
    EXPECT_GT(governor.settled(), 0.15F);
    EXPECT_LT(governor.settled(), 0.39F);
    EXPECT_EQ(governor.periods(), 1);
}

TEST(Governor, GivesWayWithinATenthOfASecondWhenTheMachineSlowsDown) {
    DetailGovernor governor({});
    Machine machine{4, 8};
    watch(governor, machine, 0s, 30s, kSteady, kNothingGrows);
    EXPECT_EQ(governor.level(), 1.0F);
    const auto throttled = [](Instant) { return 1.8F; };
    const Watched seen = watch(governor, machine, 30s, 60s, throttled, kNothingGrows);
    EXPECT_LT(seen.late, 40);
    EXPECT_LT(seen.longest_run_late, 25);
    EXPECT_LT(governor.level(), 0.65F);
    // Cooled down again, it comes back.
    const Watched after = watch(governor, machine, 60s, 10min, kSteady, kNothingGrows);
    EXPECT_GT(governor.level(), 0.9F);
    EXPECT_LE(after.late, 3);
}

TEST(Governor, DrawsLessWhileLandscapesGrowAndAsMuchAsBeforeAfterwards) {
    DetailGovernor governor({});
    Machine machine{4, 8};
    // Growing for a second in every twenty makes all of it slower.
    const auto grows = [](Instant now) { return now % 20s < 1s; };
    const auto slower = [&](Instant now) { return grows(now) ? 1.7F : 1.0F; };
    const Watched seen = watch(governor, machine, 10s, 10min, slower, grows);
    EXPECT_LE(seen.late, seen.frames / 1000 + 4);
    EXPECT_EQ(governor.settled(), 1.0F);
    EXPECT_LT(seen.least, 0.7F);
}

TEST(Governor, ShowsAFrameInTwoPeriodsWhereOneIsHopeless) {
    DetailGovernor governor({});
    Machine machine{20, 20};
    watch(governor, machine, 0s, 60s, kSteady, kNothingGrows);
    EXPECT_EQ(governor.periods(), 2);
    const Watched seen = watch(governor, machine, 60s, 5min, kSteady, kNothingGrows);
    EXPECT_LE(seen.late, seen.frames / 1000 + 2);
    EXPECT_GT(governor.settled(), 0.06F);
}

// There is a floor under the picture: below it fewer frames are shown, evenly.
TEST(Governor, ShowsFewerFramesRatherThanLessThanAPicture) {
    for (const auto& [always_ms, periods] : {std::pair{30.0F, 3}, {55.0F, 4}, {200.0F, 4}}) {
        DetailGovernor governor({});
        Machine machine{always_ms, 20};
        const Watched seen = watch(governor, machine, 0s, 3min, kSteady, [](Instant now) { return now % 20s < 2s; });
        EXPECT_EQ(governor.periods(), periods) << always_ms;
        EXPECT_GE(seen.least, GovernorOptions::kLeast);
        EXPECT_GE(scale_for(seen.least), 0.75F);
    }
}

TEST(Governor, ComesBackAPeriodAtATime) {
    DetailGovernor governor({});
    Machine machine{4, 8};
    const auto throttled = [](Instant now) { return now < 5min ? 10.0F : 1.0F; };
    watch(governor, machine, 0s, 5min, throttled, kNothingGrows);
    EXPECT_GE(governor.periods(), 3);
    watch(governor, machine, 5min, 45min, throttled, kNothingGrows);
    EXPECT_EQ(governor.periods(), 1);
    EXPECT_GT(governor.settled(), 0.9F);
}

// Where landscapes grow for two seconds in twenty: how often what a frame may take changed, and what it is at the end.
struct Periods {
    int changes = 0;
    int last = 0;
};
template <typename Slower>
Periods periods_of(DetailGovernor& governor, Machine& machine, Instant from, Instant to, const Slower& slower) {
    Periods seen{0, governor.periods()};
    for (Instant now = from; now < to; now += 1s) {
        watch(governor, machine, now, now + 1s, slower, [](Instant at) { return at % 20s < 2s; });
        seen.changes += governor.periods() != std::exchange(seen.last, governor.periods());
    }
    return seen;
}

TEST(Governor, ComesBackToOnePeriodWhenWhatSlowedItHasPassed) {
    DetailGovernor governor({});
    Machine machine{4, 8};
    const auto throttled = [](Instant now) { return now < 5min ? 6.0F : 1.0F; };
    EXPECT_EQ(periods_of(governor, machine, 0s, 5min, throttled).last, 2);
    const Periods after = periods_of(governor, machine, 5min, 10min, throttled);
    EXPECT_EQ(after.last, 1);
    EXPECT_EQ(after.changes, 1);
    const Watched seen = watch(governor, machine, 10min, 20min, throttled, kNothingGrows);
    EXPECT_LE(seen.late, seen.frames / 1000);
    EXPECT_GT(governor.settled(), 0.9F);
    // Also after a night without power, and where nobody visits.
    DetailGovernor next(options_for(1, "2 0.5 V3D", "V3D"));
    watch(next, machine, 10min, 25min, throttled, kNothingGrows);
    EXPECT_EQ(next.periods(), 1);
}

TEST(Governor, StaysAtTwoPeriodsWhereOneDoesNotDoWhileLandscapesGrow) {
    DetailGovernor governor({});
    Machine machine{11, 8};
    const auto slower = [](Instant now) { return now % 20s < 2s ? 1.7F : 1.0F; };
    EXPECT_EQ(periods_of(governor, machine, 0s, 4min, slower).last, 2);
    EXPECT_EQ(periods_of(governor, machine, 4min, 60min, slower).changes, 0);
    EXPECT_GT(governor.settled(), 0.5F) << "and draws what there is time for";
}

TEST(Governor, TriesOnePeriodEverMoreSeldomWhereItIsWrongEachTime) {
    DetailGovernor governor({});
    Machine machine{4, 8};
    int returns = 0;
    for (Instant now{0}; now < 24h;) {
        const Instant work = machine.work(governor.level(), 1);
        // Its screen takes only every other frame, however soon it is drawn.
        const Instant took = 2 * kPeriod;
        now += took;
        const int before = governor.periods();
        governor.frame({now, took, kPeriod, used_of(work, governor), now % 20s < 2s});
        returns += governor.periods() < before;
    }
    EXPECT_EQ(governor.periods(), 2);
    EXPECT_GE(returns, 8);
    EXPECT_LE(returns, 20);
}

TEST(Governor, AsksForMoreRoomWhereSingleFramesComeLateUntilTheyNoLongerDo) {
    Machine machine{4, 16};
    DetailGovernor alone({1, 0.1F});
    watch(alone, machine, 0s, 5min, kSteady, kNothingGrows);
    // Single frames, a few a minute, take more than twice as long.
    const auto disturbed = [](Instant now) { return now % 7s < 17ms ? 2.2F : 1.0F; };
    DetailGovernor governor({1, 0.1F});
    watch(governor, machine, 0s, 5min, disturbed, kNothingGrows);
    EXPECT_LT(governor.settled(), 0.8F * alone.settled());
    watch(governor, machine, 5min, 20min, kSteady, kNothingGrows);
    EXPECT_GT(governor.settled(), 0.95F * alone.settled());
}

TEST(Governor, DrawsLessWhileLandscapesGrowWhereSingleFramesComeLateThen) {
    Machine machine{6, 11};  // so that a disturbed frame is in time above the floor
    const auto is_growing = [](Instant now) { return now % 20s < 4s; };
    // What is grown takes the memory's time now and then.
    const auto disturbed = [&](Instant now) { return is_growing(now) && (now + 500ms) % 1s < 17ms ? 2.2F : 1.0F; };
    DetailGovernor governor({1, 0.5F});
    const Watched first = watch(governor, machine, 0s, 2min, disturbed, is_growing);
    const Watched later = watch(governor, machine, 2min, 4min, disturbed, is_growing);
    EXPECT_GE(first.late, 3);
    EXPECT_LE(later.late, first.late / 3);
    EXPECT_GT(later.most, 0.9F * first.most) << "where nothing grows";
    watch(governor, machine, 4min, 20min, kSteady, is_growing);
    const Watched alone = watch(governor, machine, 20min, 21min, kSteady, is_growing);
    EXPECT_GT(alone.least / alone.most, 1.2F * later.least / later.most) << "it comes back";
}

TEST(Governor, SingleFramesTakeLittleHoweverManyAndNothingWhereDrawingWasInTime) {
    for (const float used : {0.4F, 1.0F}) {
        DetailGovernor governor({1, 0.9F});
        int frame = 0;
        for (Instant now{0}; now < 10min; ++frame) {
            const bool is_late = frame % 180 == 90;
            const Instant took = is_late ? 2 * kPeriod : kPeriod;
            now += took;
            governor.frame({now, took, kPeriod, is_late ? used : 0.4F, false});
        }
        EXPECT_EQ(governor.take_reason().has_value(), used >= 1) << "what changes is said";
        EXPECT_GT(governor.settled(), used < 1 ? 0.89F : 0.7F) << used;
        EXPECT_EQ(governor.periods(), 1);
    }
}

TEST(Governor, CatchesUpFasterWhereThereIsMuchRoom) {
    const auto raised_in_half_a_minute = [](float for_detail_ms) {
        DetailGovernor governor({1, 0.05F});
        Machine machine{4, for_detail_ms};
        watch(governor, machine, 0s, 30s, kSteady, kNothingGrows);
        return governor.settled() / 0.05F;
    };
    EXPECT_GT(raised_in_half_a_minute(5), 4);
    EXPECT_LT(raised_in_half_a_minute(70), 3);
}

TEST(Governor, NeverStepsSoThatItShows) {
    DetailGovernor governor({});
    Machine machine{5, 30};
    float before = governor.level();
    for (Instant now{0}; now < 60s;) {
        const Instant work = machine.work(governor.level(), 1);
        const Instant took = work > kPeriod ? 2 * kPeriod : kPeriod;
        now += took;
        governor.frame({now, took, kPeriod, used_of(work, governor), false});
        EXPECT_LT(governor.level(), before * 1.02F);
        EXPECT_GT(governor.level(), before * 0.82F);
        before = governor.level();
    }
}

TEST(Governor, SaysWhy) {
    DetailGovernor governor({});
    Machine machine{5, 30};
    watch(governor, machine, 0s, 1s, kSteady, kNothingGrows);
    const auto reason = governor.take_reason();
    ASSERT_TRUE(reason.has_value());
    EXPECT_NE(reason->find("frames late"), std::string::npos) << *reason;
    EXPECT_FALSE(governor.take_reason().has_value());
}

// What has never been drawn costs more than what was there before it.
TEST(Governor, DrawsLessOfWhatComesBeforeTheFirstFrameOfIt) {
    DetailGovernor governor({});
    governor.frame({1s, kPeriod, kPeriod, 0.3F, false});
    const float before = governor.level();
    governor.lower_in_advance();
    const float braced = governor.level();
    EXPECT_LT(braced, 0.6F * before);
    governor.lower_in_advance();
    EXPECT_EQ(governor.level(), braced) << "once is enough";
    Instant now = 1s;
    float last = braced;
    for (int i = 0; i < 600; ++i) {
        now += kPeriod;
        governor.frame({now, kPeriod, kPeriod, 0.3F, false});
        ASSERT_GE(governor.level(), last);
        ASSERT_LT(governor.level(), 1.02F * last) << "it comes back without a step";
        last = governor.level();
    }
    EXPECT_NEAR(last, before, 1e-4F);
    EXPECT_EQ(governor.settled(), before) << "nothing else is given up";
}

TEST(Governor, LeavesMoreToWhatGrowsWhereSomebodyHadToWaitForIt) {
    DetailGovernor governor({});
    Instant now = 1s;
    const auto level_after = [&](int frames, bool is_growing) {
        for (int i = 0; i < frames; ++i) {
            now += kPeriod;
            governor.frame({now, kPeriod, kPeriod, 0.6F, is_growing});
        }
        return governor.level();
    };
    const float picture = level_after(60, false);
    const float growing = level_after(60, true);
    governor.kept_waiting();
    EXPECT_LT(level_after(1, true), 0.6F * growing);
    EXPECT_TRUE(governor.take_reason().has_value());
    EXPECT_NEAR(level_after(1200, false), picture, 0.01F) << "the picture they leave is as it was";
    EXPECT_LT(level_after(60, true), 0.6F * growing) << "the next ones too";
    for (int i = 0; i < 10; ++i) governor.kept_waiting();
    EXPECT_GT(level_after(1, true), 0.1F * picture) << "never all of it";
    EXPECT_NEAR(level_after(3600 * 20, true), growing, 0.01F) << "in twenty minutes it has come back";
}

TEST(Governor, TakesOnePeriodOfAScreenThatAsksHalfAsOften) {
    GovernorOptions slow;
    slow.start = 0.2F;
    slow.periods = 2;
    DetailGovernor governor(slow);
    Instant now = 1s;
    const auto pass = [&](Instant period, int frames) {
        for (int i = 0; i < frames; ++i) {
            now += period * governor.periods();
            governor.frame({now, period * governor.periods(), period, 0.9F, false});
        }
    };
    pass(kPeriod, 60);
    ASSERT_EQ(governor.periods(), 2);
    pass(2 * kPeriod, 1);
    EXPECT_EQ(governor.periods(), 1);
    EXPECT_EQ(governor.settled(), 0.2F) << "a frame has as long as before";
    EXPECT_THAT(governor.take_reason().value_or(""), HasSubstr("more seldom"));
    pass(kPeriod, 1);
    EXPECT_EQ(governor.periods(), 1) << "it finds out by itself whether that is hopeless again";
}

// At most, in a visit of landscapes that change every so often: what is drawn takes so much of a frame, and with smooth
// edges so much more.
struct Visits {
    DetailGovernor governor;
    Instant now = 1s;
    float used = 0.3F;
    float more = 0.1F;
    int changes = 0;

    explicit Visits(const GovernorOptions& options) : governor(options) { governor.allow_samples(4); }
    void pass(std::chrono::seconds span, std::chrono::seconds act = 20s) {
        for (const Instant end = now + span; now < end;) {
            now += kPeriod;
            const int before = governor.samples();
            if (now % act < kPeriod) governor.other_landscapes(now);
            const float taken = used + (governor.samples() > 1 ? more : 0);
            governor.frame({now, taken > 1 ? 2 * kPeriod : kPeriod, kPeriod, taken, false});
            changes += governor.samples() != before;
        }
    }
};

TEST(Governor, SmoothsEdgesWithTheNextLandscapesWhereThereIsMuchRoom) {
    Visits visits({});
    visits.pass(15s);
    EXPECT_EQ(visits.governor.samples(), 1) << "not in the midst of a picture";
    visits.pass(10s);
    EXPECT_EQ(visits.governor.samples(), 4);
    visits.pass(600s);
    EXPECT_EQ(visits.changes, 1);
}

TEST(Governor, SmoothsNoEdgesWhereThereIsLittleRoomOrTheGpuHasNoSamples) {
    Visits little({});
    little.used = 0.6F;
    little.pass(600s);
    EXPECT_EQ(little.governor.samples(), 1);
    Visits none({});
    none.governor.allow_samples(1);
    none.pass(600s);
    EXPECT_EQ(none.governor.samples(), 1);
}

TEST(Governor, GivesUpSmoothEdgesBeforeAnyDetailAndTriesThemEverMoreSeldom) {
    GovernorOptions smooth;
    smooth.samples = 4;
    Visits visits(smooth);
    visits.more = 0.9F;
    visits.pass(1s);
    EXPECT_EQ(visits.governor.samples(), 1);
    EXPECT_EQ(visits.governor.settled(), 1);
    EXPECT_THAT(visits.governor.take_reason().value_or(""), HasSubstr("smooth"));
    visits.pass(3600s * 8);
    EXPECT_LE(visits.changes, 15);
    EXPECT_GE(visits.changes, 5);
}

}  // namespace
}  // namespace quadrat::tempo
