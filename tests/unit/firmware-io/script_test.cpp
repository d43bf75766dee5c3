// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/scripted/script.hpp"

#include <gmock/gmock.h>

#include <random>

#include "firmware-io/scripted/scripted_buttons.hpp"

namespace quadrat::firmware_io::scripted {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<ButtonEdge> played(std::string_view text) {
    ScriptedButtons buttons{parse_script(text, "test")};
    return buttons.poll(100h);
}

std::string error_of(std::string_view text) {
    try {
        parse_script(text, "visit.txt");
    } catch (const ScriptError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Script, PressesAtAMomentAndAfterTheActionAbove) {
    EXPECT_THAT(played("at 2.5s press B\nafter 400ms press A\n"),
                ElementsAre(ButtonEdge{Button::B, Motion::Down, 2500ms}, ButtonEdge{Button::B, Motion::Up, 2585ms},
                            ButtonEdge{Button::A, Motion::Down, 2980ms}, ButtonEdge{Button::A, Motion::Up, 3065ms}));
}

TEST(Script, HoldsForATimeOrUntilReleased) {
    EXPECT_THAT(played("hold C for 3s  # long\nafter 1s hold D\nwait 2s\nrelease D"),
                ElementsAre(ButtonEdge{Button::C, Motion::Down, 0s}, ButtonEdge{Button::C, Motion::Up, 3005ms},
                            ButtonEdge{Button::D, Motion::Down, 4s}, ButtonEdge{Button::D, Motion::Up, 6005ms}));
}

TEST(Script, ReleaseWithoutANameLetsGoOfEverything) {
    EXPECT_EQ(played("hold A\nhold Back\nwait 1s\nrelease").size(), 4U);
}

TEST(Script, AChordIsSeveralButtonsAtOneMoment) {
    EXPECT_THAT(played("at 1s chord a+Back for 300ms"),
                ElementsAre(ButtonEdge{Button::A, Motion::Down, 1s}, ButtonEdge{Button::Back, Motion::Down, 1s},
                            ButtonEdge{Button::A, Motion::Up, 1305ms}, ButtonEdge{Button::Back, Motion::Up, 1305ms}));
}

TEST(Script, ABounceIsManyRawEdgesAndOnePress) {
    const Script script = parse_script("bounce B 12 edges over 8ms", "test");
    EXPECT_EQ(script.events.size(), 14U);  // twelve, the closing that holds, the opening
    EXPECT_EQ(played("bounce B 12 edges over 8ms").size(), 2U);
    EXPECT_EQ(script.end, 88ms);
}

TEST(Script, ActionsMayOverlapOnDifferentButtons) {
    EXPECT_THAT(played("at 1s hold A for 5s\nat 2s press B"),
                ElementsAre(ButtonEdge{Button::A, Motion::Down, 1s}, ButtonEdge{Button::B, Motion::Down, 2s},
                            ButtonEdge{Button::B, Motion::Up, 2085ms}, ButtonEdge{Button::A, Motion::Up, 6005ms}));
}

TEST(Script, EmptyLinesCommentsAndForeignLineEndsSayNothing) {
    EXPECT_EQ(played("\r\n# nothing\r\n  \t\r\npress A\r\n").size(), 2U);
    EXPECT_EQ(played("").size(), 0U);
}

TEST(Script, ErrorsNameTheFileTheLineTheTroubleAndTheRemedy) {
    EXPECT_THAT(error_of("press A\n\nat 2.5 press B"),
                AllOf(StartsWith("visit.txt:3: \"2.5\" is not a time"), HasSubstr("2.5s")));
    EXPECT_THAT(error_of("press E"),
                AllOf(StartsWith("visit.txt:1: \"E\" is not a button"), HasSubstr("A, B, C, D or Back")));
    EXPECT_THAT(error_of("push A"), AllOf(StartsWith("visit.txt:1: \"push\""), HasSubstr("press B")));
    EXPECT_THAT(error_of("at 2s press A\nat 1s press B"), StartsWith("visit.txt:2: the time lies before"));
    EXPECT_THAT(error_of("at 1s hold A for 2s\nat 2s press A"), HasSubstr("button A is still held"));
    EXPECT_THAT(error_of("release A"), HasSubstr("not held"));
    EXPECT_THAT(error_of("chord A"), HasSubstr("chord A+B"));
    EXPECT_THAT(error_of("chord A+A"), HasSubstr("still held"));
    EXPECT_THAT(error_of("wait 2000h"), HasSubstr("at most 1000h"));
    EXPECT_THAT(error_of("plug"), HasSubstr("unplug"));
    EXPECT_THAT(error_of("bounce A 999999 edges over 1s"), HasSubstr("100000"));
    EXPECT_THAT(error_of("at 1s"), HasSubstr("at 2.5s press B"));
    EXPECT_EQ(error_of(std::string("p\x01\x02\xff\n")).find('\n'), std::string::npos);
}

TEST(Script, RefusesMoreEventsThanTheLimit) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += "bounce A 40000 edges over 1s\n";
    EXPECT_THAT(error_of(text), AllOf(StartsWith("visit.txt:3:"), HasSubstr("100000")));
}

TEST(Script, AnyBytesGiveAScriptOrAnErrorOfOneLine) {
    std::mt19937 random{1};
    constexpr std::string_view kPieces[] = {
        "at ",   "after ",          "press ", "hold ", "chord ", "bounce ",     "A",   "B+C",
        "Back",  " 12 edges over ", "8ms",    " for ", "1000h",  "99999999s",   "\n",  "\n",
        "wait ", "release ",        "unplug", "plug",  "#",      "0.0000001us", "-1s", "\xc3"};
    for (int round = 0; round < 20'000; ++round) {
        std::string text;
        for (auto i = random() % 12; i > 0; --i) text += kPieces[random() % std::size(kPieces)];
        const std::string error = error_of(text);
        EXPECT_EQ(error.find('\n'), std::string::npos) << text;
    }
}

TEST(ScriptedButtons, ASimulatedClockCanJumpFromEventToEvent) {
    ScriptedButtons buttons{parse_script("at 1h press A\nafter 5h bounce B 3 edges over 3ms\nwait 10s", "test")};
    Instant now{0};
    std::vector<ButtonEdge> edges;
    int polls = 0;
    while (!buttons.is_finished()) {
        const auto next = buttons.next_event_at();
        ASSERT_TRUE(next);
        ASSERT_GE(*next, now);
        now = *next;
        const auto more = buttons.poll(now);
        for (const ButtonEdge& edge : more) EXPECT_EQ(edge.at, now) << "a jump is never past an edge";
        edges.insert(edges.end(), more.begin(), more.end());
        ASSERT_LT(++polls, 20);
    }
    EXPECT_EQ(edges.size(), 4U);
    EXPECT_EQ(now, 6h + 80ms + 3ms + 80ms + 10s);
}

TEST(ScriptedButtons, AVisitorCanBeWrittenInCode) {
    ScriptWriter visitor;
    for (int round = 0; round < 6; ++round)
        for (const Button choice : {Button::A, Button::C, Button::D}) visitor.wait(2s).press(choice);
    ScriptedButtons buttons{visitor.script()};
    EXPECT_EQ(buttons.poll(1h).size(), 36U);
    EXPECT_TRUE(buttons.is_finished());
}

TEST(ScriptedButtons, AMissingFileIsNamedWithARemedy) {
    EXPECT_THAT([] { read_script("/nowhere/visit.txt"); },
                testing::ThrowsMessage<ScriptError>(HasSubstr("/nowhere/visit.txt: cannot read: ")));
}

}  // namespace
}  // namespace quadrat::firmware_io::scripted
