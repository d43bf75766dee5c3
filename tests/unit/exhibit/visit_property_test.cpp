// SPDX-License-Identifier: Apache-2.0
// What holds of every visit, whatever is pressed and whenever.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/seed.hpp"
#include "exhibit/family.hpp"
#include "exhibit/visit.hpp"

namespace quadrat::exhibit {
namespace {

using genome::Aspect;
using genome::kAspects;

struct Moment {
    Event event;
    Instant now;
};

Event random_event(base::RandomStream& chance, int generation) {
    const auto button = static_cast<Choice>(chance.below(5));
    switch (chance.below(11)) {
        case 0:
            return Tick{};
        case 10:
            return Believed{chance.below(2) == 0, chance.below(2) == 0};
        case 4:
            return Grew{};
        case 5:
            return Stirred{};
        case 1:
            return GenerationReady{generation - static_cast<int>(chance.below(2))};
        case 2:
            return Released{button};
        case 3:
            return GenerationReady{generation};
        default:
            return Pressed{button};
    }
}

// Mostly a hurried visitor; now and then a long silence, a hold, or no time at all.
Instant random_pause(base::RandomStream& chance) {
    constexpr std::array<std::chrono::milliseconds, 5> kLongest{
        std::chrono::milliseconds{0}, std::chrono::milliseconds{350}, std::chrono::milliseconds{900},
        std::chrono::milliseconds{2'500}, std::chrono::milliseconds{30'000}};
    return std::chrono::milliseconds(chance.below(static_cast<std::uint32_t>(kLongest[chance.below(5)].count()) + 1U));
}

void expect_consistent(const State& state, const Timings& timings) {
    const bool is_visiting = state.screen != Screen::Attract;
    ASSERT_TRUE(state.screen != Screen::Language || timings.languages > 1);
    ASSERT_LT(state.first_language, std::max(1, timings.languages));
    for (const Aspect aspect : kAspects) {
        ASSERT_LT(state.answers[aspect].value_or(0), genome::kCandidates);
        if (timings.asking == Asking::Picks && (state.screen == Screen::Ask || state.screen == Screen::StillThere)) {
            ASSERT_EQ(state.answers[aspect].has_value(), aspect < state.question) << "every question before this one";
        }
    }
    if (state.screen == Screen::Attract || state.screen == Screen::Finale || state.screen == Screen::Describe ||
        state.screen == Screen::Family) {
        ASSERT_EQ(state.answers, genome::Pick{});
        ASSERT_FALSE(state.held);
    }
    if (!is_visiting || state.screen == Screen::Language) {
        ASSERT_EQ(state.rounds, 0);
        ASSERT_TRUE(state.past_answers.empty());
    }
    ASSERT_GE(state.rounds, 0);
    // Who goes on from the Finale may go on for long.
    ASSERT_LE(state.rounds, timings.finale_asks ? static_cast<int>(kMostFamily) : timings.rounds + timings.rounds_more);
    ASSERT_LE(state.family.size(), kMostFamily + static_cast<std::size_t>(timings.rounds + timings.rounds_more));
    if (!state.family.empty()) {
        ASSERT_LT(state.here, static_cast<int>(state.family.size()));
        ASSERT_LT(state.walked, static_cast<int>(state.family.size()));
        ASSERT_EQ(picks_to(state.family, state.here), state.past_answers);
        ASSERT_EQ(state.family.front().parent, -1);
    }
    ASSERT_EQ(state.family.empty(),
              timings.asking == Asking::Sliders || state.screen == Screen::Attract || state.screen == Screen::Language);
    ASSERT_TRUE(timings.finale_asks || state.screen != Screen::Family);
    const bool slides = timings.asking == Asking::Sliders;
    ASSERT_EQ(state.past_answers.size(), slides ? 0 : static_cast<std::size_t>(state.rounds));
    ASSERT_EQ(state.rounds, slides ? state.turns / 3 : state.rounds);
    ASSERT_TRUE(slides || (state.turns == 0 && state.screen != Screen::Slide));
    ASSERT_TRUE(!slides || (state.answers == genome::Pick{} && state.screen != Screen::Ask));
    ASSERT_LE(state.turns_to_undo, state.turns);
    ASSERT_LT(state.slider, std::max(1, timings.sliders));
    ASSERT_LT(state.described, std::max(1, timings.describe_words));
    ASSERT_TRUE(state.screen == Screen::Describe || state.described == 0);
    for (const genome::Pick& pick : state.past_answers)
        for (const Aspect aspect : kAspects) ASSERT_TRUE(pick[aspect]) << "a round that was bred was answered";
    if (state.screen == Screen::Breed) {
        ASSERT_FALSE(state.is_ready);
    }
    if (!slides && (state.screen == Screen::Ask || state.screen == Screen::StillThere)) {
        ASSERT_TRUE(state.is_ready);
    }
    if (state.screen == Screen::Finale) {
        ASSERT_GE(slides ? state.turns : state.rounds, 1);
    }
    ASSERT_EQ(next_deadline(state, timings).has_value(), is_visiting) << "only Attract may last for ever";
}

int count_of_generations(const std::vector<Wish>& wishes) {
    int count = 0;
    for (const Wish& wish : wishes)
        count += std::holds_alternative<PrepareVisit>(wish) || std::holds_alternative<GrowNext>(wish) ||
                 std::holds_alternative<UndoRound>(wish) || std::holds_alternative<GrowFinale>(wish) ||
                 std::holds_alternative<TurnSlider>(wish) || std::holds_alternative<UndoTurn>(wish) ||
                 std::holds_alternative<ReturnTo>(wish) || std::holds_alternative<BreedOn>(wish);
    return count;
}

void expect_right_wishes(const State& before, const Event& event, const Step& step) {
    int acknowledged = 0;
    int began = 0;
    int ended = 0;
    for (const Wish& wish : step.wishes) {
        if (const auto* acknowledge = std::get_if<Acknowledge>(&wish)) {
            ++acknowledged;
            ASSERT_EQ(acknowledge->button, std::get<Pressed>(event).button);
        }
        began += std::holds_alternative<BeginVisit>(wish);
        ended += std::holds_alternative<EndVisit>(wish);
    }
    ASSERT_EQ(acknowledged, std::holds_alternative<Pressed>(event) ? 1 : 0);
    const auto is_outside = [](Screen screen) { return screen == Screen::Attract || screen == Screen::Language; };
    ASSERT_EQ(began, is_outside(before.screen) && !is_outside(step.state.screen));
    ASSERT_EQ(ended, !is_outside(before.screen) && step.state.screen == Screen::Attract);
    ASSERT_EQ(step.state.generation - before.generation, count_of_generations(step.wishes));
}

// Every second visit turns sliders; some describe what they bred always, some never.
Timings timings_of(std::uint64_t seed) {
    Timings timings;
    timings.asking = seed % 2 == 0 ? Asking::Sliders : Asking::Picks;
    timings.sliders = 4;
    timings.describe_words = static_cast<int>(seed % 4);
    timings.describe_every = static_cast<int>(1 + seed % 2);
    timings.languages = seed % 3 == 0 ? 7 : 0;
    timings.finale_asks = seed % 3 != 1;
    timings.can_print = seed % 4 == 1;
    timings.can_breed_on = seed % 3 == 2;
    timings.rounds_early = static_cast<int>(seed % 3);
    timings.rounds_more = static_cast<int>(seed % 2);
    timings.turns = TakingTurns::Found;
    return timings;
}

class AnyVisit : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, AnyVisit, testing::Range<std::uint64_t>(1, 7));

TEST_P(AnyVisit, OfAHundredThousandEventsStaysConsistentAndAcknowledgesEveryPress) {
    const Timings timings = timings_of(GetParam());
    base::RandomStream chance(base::Seed{GetParam()});
    Instant now{0};
    State state = opening(now).state;
    std::array<int, 9> seen{};
    for (int i = 0; i < 100'000; ++i) {
        now += random_pause(chance);
        const Event event = random_event(chance, state.generation);
        const Step step = next(state, event, now, timings);
        ASSERT_EQ(step, next(state, event, now, timings)) << "the same again";
        expect_right_wishes(state, event, step);
        expect_consistent(step.state, timings);
        if (testing::Test::HasFatalFailure()) FAIL() << "event " << i;
        state = step.state;
        ++seen.at(static_cast<std::size_t>(state.screen));
    }
    for (const Screen screen : {Screen::Attract, timings.asking == Asking::Sliders ? Screen::Slide : Screen::Ask,
                                Screen::Breed, Screen::StillThere, Screen::Finale})
        EXPECT_GT(seen.at(static_cast<std::size_t>(screen)), 50) << "the walk has been everywhere";
    if (timings.describe_words > 0) {
        EXPECT_GT(seen.at(static_cast<std::size_t>(Screen::Describe)), 10);
    }
    EXPECT_EQ(seen.at(static_cast<std::size_t>(Screen::Language)) > 10, timings.languages > 1);
    EXPECT_EQ(seen.at(static_cast<std::size_t>(Screen::Family)) > 10,
              timings.finale_asks && timings.asking == Asking::Picks);
}

TEST_P(AnyVisit, DoesNotChangeWhileTimeStandsStill) {
    const Timings timings = timings_of(GetParam());
    base::RandomStream chance(base::Seed{GetParam()});
    Instant now{0};
    State state = opening(now).state;
    for (int i = 0; i < 20'000; ++i) {
        now += random_pause(chance);
        // Whatever was due happens now; after that, another look at the same clock finds nothing to do.
        for (int due = 0; due < 3; ++due) state = next(state, Tick{}, now, timings).state;
        const Step again = next(state, Tick{}, now, timings);
        ASSERT_EQ(again.state, state);
        ASSERT_TRUE(again.wishes.empty());
        const Step earlier = next(state, Tick{}, now - std::chrono::hours(1), timings);
        ASSERT_EQ(earlier.state, state) << "nor does a clock that runs back change anything";
        state = next(state, random_event(chance, state.generation), now, timings).state;
    }
}

TEST_P(AnyVisit, ChangesAtItsDeadlineAndNotANanosecondBefore) {
    const Timings timings = timings_of(GetParam());
    base::RandomStream chance(base::Seed{GetParam()});
    Instant now{0};
    State state = opening(now).state;
    int deadlines = 0;
    for (int i = 0; i < 20'000; ++i) {
        now += random_pause(chance);
        state = next(state, random_event(chance, state.generation), now, timings).state;
        const auto deadline = next_deadline(state, timings);
        if (!deadline || *deadline <= now) continue;
        const Step early = next(state, Tick{}, *deadline - Instant{1}, timings);
        ASSERT_EQ(early.state, state);
        ASSERT_TRUE(early.wishes.empty());
        ASSERT_NE(next(state, Tick{}, *deadline, timings).state, state);
        ++deadlines;
    }
    EXPECT_GT(deadlines, 1'000);
}

TEST_P(AnyVisit, EndsInAttractWhenNobodyPressesAnyMore) {
    const Timings timings = timings_of(GetParam());
    base::RandomStream chance(base::Seed{GetParam()});
    Instant now{0};
    State state = opening(now).state;
    for (int i = 0; i < 5'000; ++i) {
        now += random_pause(chance);
        state = next(state, random_event(chance, state.generation), now, timings).state;
        const bool does_growing_work = chance.below(2) == 0;
        State left = state;
        int steps = 0;
        for (; left.screen != Screen::Attract; ++steps) {
            ASSERT_LT(steps, 10) << "going round in circles";
            const Event event = does_growing_work && left.screen == Screen::Breed
                                    ? Event(GenerationReady{left.generation})
                                    : Event(Tick{});
            left = next(left, event, next_deadline(left, timings).value(), timings).state;
        }
    }
}

}  // namespace
}  // namespace quadrat::exhibit
