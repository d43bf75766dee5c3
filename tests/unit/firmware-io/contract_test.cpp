// SPDX-License-Identifier: Apache-2.0
// What every source of presses promises, held against each of them.
#include <gmock/gmock.h>

#include <random>

#include "rigs.hpp"

namespace quadrat::tests {
namespace {

using namespace std::chrono_literals;
using firmware_io::index_of;
using firmware_io::kButtons;
using firmware_io::Presence;
using testing::IsEmpty;

constexpr Instant kSettled = 1s;  // by then every source has opened its device

std::vector<std::pair<Button, Motion>> motions(const std::vector<ButtonEdge>& edges) {
    std::vector<std::pair<Button, Motion>> motions;
    for (const ButtonEdge& edge : edges) motions.emplace_back(edge.button, edge.motion);
    return motions;
}
using Motions = std::vector<std::pair<Button, Motion>>;

class ButtonSourceContract : public testing::TestWithParam<RigKind> {
  protected:
    std::unique_ptr<Rig> rig = GetParam().make();
};

TEST_P(ButtonSourceContract, OnePressIsOneDownAndOneUp) {
    for (std::size_t i = 0; i < kButtons.size(); ++i) rig->press(kButtons[i], kSettled + 500ms * static_cast<int>(i));
    Motions expected;
    for (const Button button : kButtons) {
        expected.emplace_back(button, Motion::Down);
        expected.emplace_back(button, Motion::Up);
    }
    EXPECT_EQ(motions(rig->run(5s)), expected);
}

TEST_P(ButtonSourceContract, APressIsToldWithinOnePollOfItsClosing) {
    rig->press(Button::C, kSettled + 400us);
    const auto edges = rig->run(kSettled + 1ms);
    ASSERT_EQ(motions(edges), (Motions{{Button::C, Motion::Down}}));
    EXPECT_GE(edges.front().at, kSettled + 400us);
    EXPECT_LE(edges.front().at, kSettled + 1ms);
}

TEST_P(ButtonSourceContract, BounceNeverDoublesAPress) {
    for (int edges = 1; edges < 40; ++edges) {
        const Instant at = kSettled + 300ms * edges;
        rig->bounce(Button::B, at, edges, 8ms);
        for (int i = 0; i < edges; ++i)  // and so it opens
            rig->schedule({i % 2 == 0 ? Act::Open : Act::Close, Button::B, at + 100ms + 100us * i});
        rig->schedule({Act::Open, Button::B, at + 110ms});
    }
    const auto heard = motions(rig->run(15s));
    ASSERT_EQ(heard.size(), 2U * 39);
    for (std::size_t i = 0; i < heard.size(); ++i)
        EXPECT_EQ(heard[i], std::pair(Button::B, i % 2 == 0 ? Motion::Down : Motion::Up)) << i;
}

TEST_P(ButtonSourceContract, AHeldButtonNeverRepeats) {
    rig->press(Button::D, kSettled, 1h);
    EXPECT_EQ(motions(rig->run(kSettled + 59min, 16ms)), (Motions{{Button::D, Motion::Down}}));
    const auto contact = rig->source().contacts()[index_of(Button::D)];
    EXPECT_TRUE(contact.is_down);
    EXPECT_TRUE(contact.is_closed);
    EXPECT_LE(contact.down_since, kSettled + 16ms);
    EXPECT_EQ(motions(rig->run(kSettled + 61min, 16ms)), (Motions{{Button::D, Motion::Up}}));
    EXPECT_FALSE(rig->source().contacts()[index_of(Button::D)].is_down);
}

TEST_P(ButtonSourceContract, AChordDeliversAllOfIt) {
    for (const Button button : {Button::A, Button::B, Button::D}) rig->press(button, kSettled, 300ms);
    EXPECT_THAT(motions(rig->run(kSettled + 100ms)),
                testing::UnorderedElementsAre(std::pair(Button::A, Motion::Down), std::pair(Button::B, Motion::Down),
                                              std::pair(Button::D, Motion::Down)));
    EXPECT_THAT(motions(rig->run(kSettled + 400ms)),
                testing::UnorderedElementsAre(std::pair(Button::A, Motion::Up), std::pair(Button::B, Motion::Up),
                                              std::pair(Button::D, Motion::Up)));
}

TEST_P(ButtonSourceContract, UnpluggedWhileDownGivesAnUpAndNoPressUntilItWasReleased) {
    rig->press(Button::A, kSettled, 20s);
    rig->schedule({Act::Unplug, Button::A, kSettled + 1s});
    rig->schedule({Act::Plug, Button::A, kSettled + 5s});
    rig->press(Button::A, kSettled + 25s);
    EXPECT_EQ(motions(rig->run(kSettled + 1500ms)), (Motions{{Button::A, Motion::Down}, {Button::A, Motion::Up}}));
    EXPECT_THAT(rig->run(kSettled + 24s), IsEmpty());
    EXPECT_EQ(motions(rig->run(kSettled + 30s)), (Motions{{Button::A, Motion::Down}, {Button::A, Motion::Up}}));
}

TEST_P(ButtonSourceContract, WorksAgainWithinTwoSecondsOfPluggingInAHundredTimes) {
    for (int cycle = 0; cycle < 100; ++cycle) {
        const Instant at = kSettled + 6s * cycle;
        rig->schedule({Act::Unplug, Button::A, at});
        rig->schedule({Act::Plug, Button::A, at + 1s + 17ms * cycle});
        rig->press(kButtons[static_cast<std::size_t>(cycle) % 5], at + 1s + 17ms * cycle + 1300ms);
    }
    const auto heard = motions(rig->run(kSettled + 601s, 16ms));
    ASSERT_EQ(heard.size(), 200U);
    for (std::size_t i = 0; i < heard.size(); ++i)
        EXPECT_EQ(heard[i], std::pair(kButtons[i / 2 % 5], i % 2 == 0 ? Motion::Down : Motion::Up)) << i;
    EXPECT_EQ(rig->source().status().presence, Presence::Present);
}

TEST_P(ButtonSourceContract, AbsentAtTheStartIsSaidWithARemedyAndItsPressesCountLater) {
    if (!rig->can_be_absent()) {
        rig->schedule({Act::Unplug, Button::A, 0s});
        rig->poll(1ms);
        EXPECT_EQ(rig->source().status(), firmware_io::SourceStatus{});
        return;
    }
    rig->schedule({Act::Unplug, Button::A, 0s});
    rig->schedule({Act::Plug, Button::A, 10s});
    rig->press(Button::B, 13s);
    rig->poll(1ms);
    const auto first = rig->source().status();
    EXPECT_EQ(first.presence, Presence::Absent);
    EXPECT_THAT(first.reason, testing::HasSubstr(";"));
    EXPECT_EQ(first.reason.find('\n'), std::string::npos);
    EXPECT_THAT(rig->run(9s), IsEmpty());
    EXPECT_EQ(rig->source().status(), first) << "the same trouble is the same words";
    EXPECT_EQ(motions(rig->run(14s)), (Motions{{Button::B, Motion::Down}, {Button::B, Motion::Up}}));
    EXPECT_EQ(rig->source().status().presence, Presence::Present);
}

TEST_P(ButtonSourceContract, PollingTwiceAtOneMomentDeliversNothingNew) {
    for (int i = 0; i < 20; ++i) rig->press(kButtons[static_cast<std::size_t>(i) % 5], kSettled + 90ms * i, 60ms);
    std::size_t heard = 0;
    for (Instant now = 1ms; now < 4s; now += 7ms) {
        heard += rig->poll(now).size();
        EXPECT_THAT(rig->poll(now), IsEmpty());
    }
    EXPECT_EQ(heard, 40U);
}

TEST_P(ButtonSourceContract, EdgesAlternateAndComeInOrderOfTimeWhateverTheContactsDo) {
    std::mt19937 random{20240607};
    for (int i = 0; i < 3000; ++i) {
        const Instant at = kSettled + std::chrono::microseconds{random() % 20'000'000};
        rig->schedule({random() % 2 == 0 ? Act::Close : Act::Open, kButtons[random() % 5], at});
        if (i % 500 == 0) rig->schedule({Act::Unplug, Button::A, at});
        if (i % 500 == 0) rig->schedule({Act::Plug, Button::A, at + 300ms});
    }
    std::array<bool, kButtons.size()> is_down{};
    Instant last{0};
    std::size_t heard = 0;
    for (Instant now = 0ms; now < 25s; now += 3ms) {
        for (const ButtonEdge& edge : rig->poll(now)) {
            EXPECT_LE(edge.at, now);
            EXPECT_GE(edge.at, last);
            last = edge.at;
            EXPECT_NE(is_down[index_of(edge.button)], edge.motion == Motion::Down);
            is_down[index_of(edge.button)] = edge.motion == Motion::Down;
            ++heard;
        }
        for (const Button button : kButtons)
            EXPECT_EQ(rig->source().contacts()[index_of(button)].is_down, is_down[index_of(button)]);
    }
    EXPECT_GT(heard, 100U);
}

INSTANTIATE_TEST_SUITE_P(Every, ButtonSourceContract, testing::ValuesIn(every_rig()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace quadrat::tests
