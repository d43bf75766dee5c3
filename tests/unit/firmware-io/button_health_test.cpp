// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/button_health.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "firmware-io/scripted/scripted_buttons.hpp"

namespace quadrat::firmware_io {
namespace {

using namespace std::chrono_literals;
using scripted::ScriptWriter;

constexpr Instant kFrame = 16ms;

// A panel that is pressed by a script and watched frame by frame, as the kiosk does it.
struct WatchedPanel {
    scripted::ScriptedButtons buttons;
    ButtonHealth health;
    std::vector<ButtonEdge> heard;
    std::vector<FindingChange> changes;
    Instant now{0};

    explicit WatchedPanel(scripted::Script script, HealthLimits limits = {}, HealthMemory memory = {})
        : buttons{std::move(script)}, health{limits, memory} {}

    void run(Instant until, Instant step = kFrame) {
        for (; now < until; now += step) {
            const auto edges = health.hear(buttons.poll(now), buttons.contacts(), now);
            heard.insert(heard.end(), edges.begin(), edges.end());
            const auto news = health.take_changes();
            changes.insert(changes.end(), news.begin(), news.end());
        }
    }
    long presses(Button button) const {
        return std::count_if(heard.begin(), heard.end(), [&](const ButtonEdge& edge) {
            return edge.button == button && edge.motion == Motion::Down;
        });
    }
    long balance(Button button) const {
        return 2 * presses(button) -
               std::count_if(heard.begin(), heard.end(), [&](const ButtonEdge& edge) { return edge.button == button; });
    }
    std::uint64_t count(Ailment ailment, Button button) const {
        return health.counts()[static_cast<std::size_t>(ailment)][index_of(button)];
    }
};

scripted::Script storm(Button button, Instant from, Instant span, Instant gap) {
    scripted::Script script;
    for (Instant at = from; at < from + span; at += 2 * gap) {
        script.events.push_back({at, scripted::Happening::Close, button});
        script.events.push_back({at + gap, scripted::Happening::Open, button});
    }
    script.end = from + span;
    return script;
}

scripted::Script together(scripted::Script a, const scripted::Script& b) {
    a.events.insert(a.events.end(), b.events.begin(), b.events.end());
    std::stable_sort(a.events.begin(), a.events.end(), [](const auto& x, const auto& y) { return x.at < y.at; });
    a.end = std::max(a.end, b.end);
    return a;
}

TEST(ButtonHealth, AnOrdinaryVisitFindsNothingAndHearsEverything) {
    ScriptWriter visitor;
    for (int i = 0; i < 200; ++i) visitor.wait(700ms).bounce(kButtons[static_cast<std::size_t>(i) % 4], 30, 6ms);
    WatchedPanel panel{visitor.script()};
    panel.run(5min);
    EXPECT_EQ(panel.heard.size(), 400U);
    EXPECT_TRUE(panel.changes.empty());
}

TEST(ButtonHealth, TheFastestHandIsNotChattering) {
    scripted::Script masher;
    for (int press = 0; press < 140; ++press) {  // 14 a second, each with ten bounces on its way down
        const Instant at = 1s + 71ms * press;
        for (int i = 0; i < 11; ++i)
            masher.events.push_back(
                {at + 400us * i, i % 2 == 0 ? scripted::Happening::Close : scripted::Happening::Open, Button::A});
        masher.events.push_back({at + 35ms, scripted::Happening::Open, Button::A});
    }
    WatchedPanel panel{masher};
    panel.run(20s);
    EXPECT_EQ(panel.presses(Button::A), 140);
    EXPECT_TRUE(panel.changes.empty());
}

TEST(ButtonHealth, AStormOfAThousandEdgesASecondIsMaskedWithinASecondAndTheOthersStillPlay) {
    ScriptWriter visitor;
    for (int i = 0; i < 20; ++i) visitor.wait(1s).press(Button::A);
    WatchedPanel panel{together(storm(Button::B, 2s, 15s, 1ms), visitor.script())};
    panel.run(4s);
    ASSERT_EQ(panel.health.findings().size(), 1U);
    EXPECT_EQ(panel.health.findings()[0].ailment, Ailment::Chattering);
    EXPECT_EQ(panel.health.findings()[0].button, Button::B);
    EXPECT_LT(panel.health.findings()[0].since, 3100ms);
    EXPECT_TRUE(panel.health.is_masked(Button::B));
    panel.run(40s);
    EXPECT_EQ(panel.presses(Button::A), 20);
    EXPECT_EQ(panel.presses(Button::B), 1) << "the storm was one false press";
    EXPECT_EQ(panel.balance(Button::B), 0) << "and it was let go";
    EXPECT_TRUE(panel.health.findings().empty()) << "recovered";
    EXPECT_EQ(panel.count(Ailment::Chattering, Button::B), 1U);
}

TEST(ButtonHealth, ASlowChatterThatDebouncingCannotSeeIsAtMostFiveFalsePresses) {
    WatchedPanel panel{storm(Button::C, 1s, 10s, 12ms)};
    panel.run(30s);
    EXPECT_LE(panel.presses(Button::C), 5);
    EXPECT_EQ(panel.balance(Button::C), 0);
    EXPECT_EQ(panel.count(Ailment::Chattering, Button::C), 1U);
}

TEST(ButtonHealth, AButtonLeanedOnForAnHourIsLeanedOnThenStuckThenWellAgain) {
    WatchedPanel panel{ScriptWriter{}.at(5s).hold(Button::D, 1h).wait(10s).press(Button::D).script()};
    panel.run(1h + 30s);
    std::vector<std::pair<Ailment, Turn>> story;
    for (const FindingChange& change : panel.changes) story.emplace_back(change.finding.ailment, change.turn);
    EXPECT_EQ(story, (std::vector<std::pair<Ailment, Turn>>{{Ailment::LeanedOn, Turn::Began},
                                                            {Ailment::Stuck, Turn::Began},
                                                            {Ailment::LeanedOn, Turn::Ended},
                                                            {Ailment::Stuck, Turn::Ended}}));
    EXPECT_NEAR(std::chrono::duration<double>(panel.changes[0].at - 15s).count(), 0, 0.1);
    EXPECT_NEAR(std::chrono::duration<double>(panel.changes[1].at - 65s).count(), 0, 0.1);
    EXPECT_EQ(panel.presses(Button::D), 2);
    EXPECT_EQ(panel.balance(Button::D), 0);
    EXPECT_EQ(panel.heard[1].motion, Motion::Up);
    EXPECT_LT(panel.heard[1].at, 66s) << "a stuck button is let go for the visit's sake";
}

TEST(ButtonHealth, AButtonStuckSinceBeforeTheStartIsFoundThoughItWasNeverPressed) {
    scripted::Script script;
    script.events = {{0s, scripted::Happening::Unplug},
                     {0s, scripted::Happening::Close, Button::A},
                     {1s, scripted::Happening::Plug}};
    WatchedPanel panel{script};
    panel.run(2min);
    EXPECT_TRUE(panel.heard.empty());
    ASSERT_EQ(panel.health.findings().size(), 1U);
    EXPECT_EQ(panel.health.findings()[0], (Finding{Ailment::Stuck, Button::A, 1s}));
}

TEST(ButtonHealth, AMaskedButtonIsHeardAgainOnlyAfterAQuietTime) {
    WatchedPanel panel{
        ScriptWriter{}.at(1s).hold(Button::B, 70s).wait(1s).press(Button::B).wait(4s).press(Button::B).script()};
    panel.run(2min);
    EXPECT_EQ(panel.presses(Button::B), 2) << "the one that stuck and the last";
}

TEST(ButtonHealth, TwoAtOnceAndAllAtOnceAreToldAndHeard) {
    WatchedPanel panel{ScriptWriter{}
                           .at(1s)
                           .chord({Button::A, Button::C}, 300ms)
                           .wait(1s)
                           .chord({Button::A, Button::B, Button::C, Button::D}, 300ms)
                           .wait(1s)
                           .chord({Button::A, Button::Back}, 300ms)
                           .script()};
    panel.run(10s);
    EXPECT_EQ(panel.count(Ailment::PressedTogether, Button::C) + panel.count(Ailment::PressedTogether, Button::D), 2U);
    EXPECT_EQ(panel.count(Ailment::AllPressed, Button::D), 1U);
    EXPECT_EQ(panel.heard.size(), 16U);
    EXPECT_TRUE(panel.health.findings().empty());
}

TEST(ButtonHealth, AButtonUnpressedForAWeekOfRunningTimeIsDeadEvenAcrossRestarts) {
    HealthMemory memory;
    for (int day = 0; day < 8; ++day) {
        ScriptWriter visitor;
        for (int i = 0; i < 60; ++i) {
            visitor.wait(8min - 80ms).press(kButtons[static_cast<std::size_t>(i) % 3]);  // never D, never Back
        }
        WatchedPanel panel{visitor.script(), {}, memory};
        panel.run(8h + 2s, 1s);
        memory = panel.health.memory();
        const auto dead = [&](Button button) { return panel.count(Ailment::Dead, button) > 0; };
        EXPECT_EQ(dead(Button::D), day >= 6) << day;
        EXPECT_FALSE(dead(Button::A));
    }
    WatchedPanel panel{ScriptWriter{}.at(1s).press(Button::D).script(), {}, memory};
    panel.run(2s);
    ASSERT_EQ(panel.changes.size(), 3U) << "D and Back begin as dead, and D is alive after all";
    EXPECT_EQ(panel.changes[2].finding.button, Button::D);
    EXPECT_EQ(panel.changes[2].turn, Turn::Ended);
}

TEST(ButtonHealth, InAQuietWeekNobodyIsDead) {
    HealthMemory memory;
    memory.unpressed_for.fill(60h);
    WatchedPanel panel{scripted::Script{}, {}, memory};
    panel.run(10s);
    EXPECT_TRUE(panel.changes.empty());
}

TEST(ButtonHealth, WhatIsHeardAlternatesHoweverFaultyThePanel) {
    auto script = together(storm(Button::A, 1s, 30s, 1ms), storm(Button::B, 5s, 100s, 9ms));
    script = together(script, ScriptWriter{}.at(20s).hold(Button::C, 200s).script());
    WatchedPanel panel{script};
    panel.run(5min);
    std::array<bool, kButtons.size()> is_down{};
    Instant last{0};
    for (const ButtonEdge& edge : panel.heard) {
        EXPECT_NE(is_down[index_of(edge.button)], edge.motion == Motion::Down);
        is_down[index_of(edge.button)] = edge.motion == Motion::Down;
        EXPECT_GE(edge.at, last);
        last = edge.at;
    }
    for (const Button button : kButtons) EXPECT_EQ(panel.balance(button), 0) << name_of(button);
}

}  // namespace
}  // namespace quadrat::firmware_io
