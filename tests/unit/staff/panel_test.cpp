// SPDX-License-Identifier: Apache-2.0
#include "staff/panel.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/log.hpp"
#include "firmware-io/scripted/scripted_buttons.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;
using namespace firmware_io;
using scripted::ScriptWriter;

// The lamps as they were last asked for.
class Lit : public ButtonSource {
  public:
    explicit Lit(scripted::Script script) : buttons_{std::move(script)} {}
    std::vector<ButtonEdge> poll(Instant now) override { return buttons_.poll(now); }
    SourceStatus status() const override { return buttons_.status(); }
    const Contacts& contacts() const override { return buttons_.contacts(); }
    void set_lamps(const Lamps& lamps) override { last = lamps; }
    Lamps last{};

  private:
    scripted::ScriptedButtons buttons_;
};

struct APanel {
    Lit buttons;
    Panel panel{buttons};
    std::vector<ButtonEdge> heard;
    Instant now{0};
    int chords = 0;

    explicit APanel(const ScriptWriter& script) : buttons{script.script()} {}
    void run(Instant until) {
        for (; now < until; now += 16ms) {
            const auto edges = panel.poll(now);
            heard.insert(heard.end(), edges.begin(), edges.end());
            chords += panel.take_chord();
        }
    }
    long count(Button button, Motion motion) const {
        return std::count_if(heard.begin(), heard.end(),
                             [&](const ButtonEdge& edge) { return edge.button == button && edge.motion == motion; });
    }
};

TEST(Panel, CountsThePressesOfEachButton) {
    APanel it{ScriptWriter{}.at(1s).press(Button::B).wait(1s).press(Button::B).wait(1s).press(Button::Back)};
    it.run(6s);
    EXPECT_EQ(it.panel.presses_of(), (std::array<std::uint64_t, kButtons.size()>{0, 2, 0, 0, 1}));
    EXPECT_EQ(it.panel.presses(), 3U);
}

TEST(Panel, TheChordOpensOnceAndNoVisitHearsItAsALongPress) {
    APanel it{ScriptWriter{}.at(1s).chord({Button::A, Button::Back}, 20s).wait(1s).press(Button::A)};
    it.run(1s + 4900ms);
    EXPECT_EQ(it.chords, 0);
    EXPECT_EQ(it.count(Button::A, Motion::Up), 1) << "let go, as far as a visit is concerned";
    it.run(25s);
    EXPECT_EQ(it.chords, 1);
    EXPECT_EQ(it.count(Button::A, Motion::Down), 2);
    EXPECT_EQ(it.count(Button::A, Motion::Up), 2);
    EXPECT_EQ(it.count(Button::Back, Motion::Down), it.count(Button::Back, Motion::Up));
}

TEST(Panel, TheChordIsTimedByItsPressesHoweverLateAFrameHearsOfThem) {
    APanel late{ScriptWriter{}.at(1s).chord({Button::A, Button::Back}, 6s)};
    late.run(500ms);
    late.now = 3s;
    late.run(6200ms);
    EXPECT_EQ(late.chords, 1) << "held since the first second";
    APanel very_late{ScriptWriter{}.at(1s).chord({Button::A, Button::Back}, 6s).wait(2s)};
    very_late.run(500ms);
    very_late.now = 8s;
    very_late.run(8100ms);
    EXPECT_EQ(very_late.chords, 1) << "held and let go between two frames";
    EXPECT_EQ(very_late.count(Button::A, Motion::Down), very_late.count(Button::A, Motion::Up));
    APanel short_one{ScriptWriter{}.at(1s).chord({Button::A, Button::Back}, 4s).wait(2s)};
    short_one.run(500ms);
    short_one.now = 7s;
    short_one.run(12s);
    EXPECT_EQ(short_one.chords, 0) << "let go before its time, whenever that was heard";
}

TEST(Panel, AStuckButtonIsLeftOutOfTheVisitAndSaid) {
    base::open_log(base::LogDetail::Quiet);
    const std::size_t warnings = base::recent_warnings().count;
    APanel it{ScriptWriter{}.at(1s).hold(Button::B, 100s).press(Button::C)};
    it.run(90s);
    ASSERT_EQ(it.panel.health().findings().size(), 1U);
    EXPECT_EQ(it.panel.health().findings()[0].ailment, Ailment::Stuck);
    EXPECT_EQ(it.count(Button::B, Motion::Up), 1);
    it.run(110s);
    EXPECT_TRUE(it.panel.health().findings().empty());
    EXPECT_EQ(it.count(Button::C, Motion::Down), 1);
    EXPECT_EQ(it.panel.presses(), 2U);
    const auto said = base::recent_warnings();
    EXPECT_GE(said.count, warnings + 2) << "leaned on, then stuck";
    EXPECT_NE(said.lines.back().find("button B is stuck"), std::string::npos) << said.lines.back();
}

TEST(Panel, TheLampOfAPressedButtonWinks) {
    APanel it{ScriptWriter{}.at(1s).press(Button::A)};
    Lamps lamps{};
    lamps.fill(LampPattern::Steady);
    it.run(1s + 20ms);
    it.panel.light(lamps, it.now);
    EXPECT_EQ(it.buttons.last[0], LampPattern::Off);
    EXPECT_EQ(it.buttons.last[1], LampPattern::Steady);
    it.run(2s);
    it.panel.light(lamps, it.now);
    EXPECT_EQ(it.buttons.last[0], LampPattern::Steady);
}

TEST(Panel, WhatItRemembersIsReadAgainAndAnythingElseIsNothing) {
    HealthMemory memory;
    memory.unpressed_for[2] = 70h;
    memory.others_pressed[2] = 500;
    EXPECT_EQ(health_memory_from(to_text(memory)), memory);
    for (const char* text : {"", "1 2 3", "-1 0 0 0 0 0 0 0 0 0", "a b", "99999999999999999999 0 0 0 0 0 0 0 0 0"})
        EXPECT_EQ(health_memory_from(text), HealthMemory{}) << text;
    Lit buttons{ScriptWriter{}.script()};
    Panel panel{buttons, memory};
    panel.poll(0s);
    ASSERT_EQ(panel.health().findings().size(), 1U) << "dead for a week, over many evenings";
    EXPECT_EQ(panel.health().findings()[0].button, Button::C);
}

}  // namespace
}  // namespace quadrat::staff
