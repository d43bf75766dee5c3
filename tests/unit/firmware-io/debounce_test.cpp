// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/debounce.hpp"

#include <gmock/gmock.h>

#include <random>

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr Button kB = Button::B;

std::vector<ButtonEdge> settle(DebounceForm form, const std::vector<std::pair<Instant, bool>>& train) {
    Debouncer debouncer{{form, 5ms}};
    for (const auto& [at, is_closed] : train) debouncer.contact(kB, is_closed, at);
    return debouncer.take(1h);
}

TEST(Debouncer, FirstEdgeAnswersAtOnceAndLetsGoAfterFiveQuietMilliseconds) {
    EXPECT_THAT(settle(DebounceForm::FirstEdge, {{10ms, true}, {100ms, false}}),
                ElementsAre(ButtonEdge{kB, Motion::Down, 10ms}, ButtonEdge{kB, Motion::Up, 105ms}));
}

TEST(Debouncer, FirstEdgeKeepsAPressDownThroughGapsShorterThanThePeriod) {
    EXPECT_THAT(settle(DebounceForm::FirstEdge, {{10ms, true}, {20ms, false}, {24ms, true}, {50ms, false}}),
                ElementsAre(ButtonEdge{kB, Motion::Down, 10ms}, ButtonEdge{kB, Motion::Up, 55ms}));
}

TEST(Debouncer, TwoPressesSixMillisecondsApartAreTwo) {
    EXPECT_EQ(settle(DebounceForm::FirstEdge, {{10ms, true}, {20ms, false}, {26ms, true}, {50ms, false}}).size(), 4U);
}

TEST(Debouncer, TheIntegratorAnswersWhenItsChargeIsFull) {
    EXPECT_THAT(settle(DebounceForm::Integrator, {{10ms, true}, {100ms, false}}),
                ElementsAre(ButtonEdge{kB, Motion::Down, 15ms}, ButtonEdge{kB, Motion::Up, 105ms}));
    // 3 ms closed, 1 ms open, and the charge of 2 ms needs 3 ms more.
    EXPECT_THAT(settle(DebounceForm::Integrator, {{10ms, true}, {13ms, false}, {14ms, true}, {100ms, false}}),
                ElementsAre(ButtonEdge{kB, Motion::Down, 17ms}, ButtonEdge{kB, Motion::Up, 105ms}));
}

TEST(Debouncer, TheIntegratorHearsNoPressInSpikes) {
    std::vector<std::pair<Instant, bool>> spikes;
    for (int i = 0; i < 1000; ++i) {
        spikes.emplace_back(10ms * i, true);
        spikes.emplace_back(10ms * i + 4ms, false);
    }
    EXPECT_THAT(settle(DebounceForm::Integrator, spikes), IsEmpty());
}

TEST(Debouncer, NothingIsDeliveredBeforeItsTime) {
    Debouncer debouncer{{DebounceForm::Integrator, 5ms}};
    debouncer.contact(kB, true, 10ms);
    EXPECT_EQ(debouncer.next_event_at(), 15ms);
    EXPECT_THAT(debouncer.take(15ms - 1ns), IsEmpty());
    EXPECT_EQ(debouncer.take(15ms).size(), 1U);
    EXPECT_EQ(debouncer.next_event_at(), std::nullopt);
}

TEST(Debouncer, AContactFoundClosedIsNoPressUntilItHasBeenOpenForAPeriod) {
    for (const DebounceForm form : {DebounceForm::FirstEdge, DebounceForm::Integrator}) {
        Debouncer debouncer{{form, 5ms}};
        debouncer.found(kB, true, 1ms);
        EXPECT_THAT(debouncer.take(10s), IsEmpty());
        EXPECT_TRUE(debouncer.contacts()[index_of(kB)].is_closed) << "a stuck button can still be seen";
        debouncer.contact(kB, false, 11s);
        debouncer.contact(kB, true, 11s + 2ms);
        EXPECT_THAT(debouncer.take(12s), IsEmpty()) << "that was a bounce of the release";
        debouncer.contact(kB, false, 13s);
        debouncer.contact(kB, true, 14s);
        EXPECT_EQ(debouncer.take(15s).size(), 1U);
    }
}

TEST(Debouncer, WithoutAPeriodEveryEdgeGoesThrough) {
    Debouncer debouncer{{DebounceForm::FirstEdge, 0ms}};
    for (int i = 0; i < 10; ++i) debouncer.contact(kB, i % 2 == 0, 1ms * i);
    EXPECT_EQ(debouncer.take(1s).size(), 10U);
}

TEST(Debouncer, CountsTheEdgesThatItSwallows) {
    Debouncer debouncer;
    for (int i = 0; i < 100; ++i) debouncer.contact(kB, i % 2 == 0, 1ms * i);
    debouncer.take(1s);
    EXPECT_EQ(debouncer.contacts()[index_of(kB)].raw_edges, 100U);
    EXPECT_EQ(debouncer.contacts()[index_of(Button::A)].raw_edges, 0U);
}

TEST(Debouncer, AMomentBeforeWhatWasTakenIsTakenAsThatMoment) {
    Debouncer debouncer;
    debouncer.take(1s);
    debouncer.contact(kB, true, 500ms);
    EXPECT_THAT(debouncer.take(2s), ElementsAre(ButtonEdge{kB, Motion::Down, 1s}));
}

// Against random trains: edges alternate and are ordered; every Up comes after a whole quiet period; there are no more
// presses than closings that follow a gap of at least the period; however often and when the train is polled, the edges
// are the same.
class DebouncerOnRandomTrains : public testing::TestWithParam<DebounceForm> {};

TEST_P(DebouncerOnRandomTrains, KeepsItsPromises) {
    std::mt19937 random{7};
    for (int train = 0; train < 300; ++train) {
        const int longest_us = train % 3 == 0 ? 3'000 : 30'000;
        Debouncer at_once{{GetParam(), 5ms}}, in_steps{{GetParam(), 5ms}};
        std::vector<ButtonEdge> stepped;
        Instant at{0};
        std::size_t presses_possible = 0;
        for (int i = 0; i < 200; ++i) {
            const Instant gap = std::chrono::microseconds{random() % longest_us};
            for (Instant poll = at; poll < at + gap; poll += 1300us) {
                const auto edges = in_steps.take(poll);
                stepped.insert(stepped.end(), edges.begin(), edges.end());
            }
            at += gap;
            const bool is_closed = i % 2 == 0;
            if (is_closed && (i == 0 || gap >= 5ms)) ++presses_possible;
            at_once.contact(kB, is_closed, at);
            in_steps.contact(kB, is_closed, at);
        }
        const auto edges = at_once.take(at + 1s);
        const auto last = in_steps.take(at + 1s);
        stepped.insert(stepped.end(), last.begin(), last.end());
        EXPECT_EQ(edges, stepped);
        ASSERT_EQ(edges.size() % 2, 0U);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            EXPECT_EQ(edges[i].motion, i % 2 == 0 ? Motion::Down : Motion::Up);
            if (i > 0) {
                EXPECT_GE(edges[i].at, edges[i - 1].at + (i % 2 == 1 ? 5ms : 0ms));
            }
        }
        if (GetParam() == DebounceForm::FirstEdge) {
            EXPECT_EQ(edges.size() / 2, presses_possible);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Form, DebouncerOnRandomTrains,
                         testing::Values(DebounceForm::FirstEdge, DebounceForm::Integrator), [](const auto& form) {
                             return form.param == DebounceForm::FirstEdge ? "FirstEdge" : "Integrator";
                         });

}  // namespace
}  // namespace quadrat::firmware_io
