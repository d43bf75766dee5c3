// SPDX-License-Identifier: Apache-2.0
#include "kiosk/switchboard.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "firmware-io/button_source.hpp"
#include "genome/scene_code.hpp"
#include "kiosk/show.hpp"
#include "support/process.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;
using exhibit::Choice;
using exhibit::Screen;
using firmware_io::Button;
using firmware_io::LampPattern;
using firmware_io::Motion;

// An exhibit without a screen, before somebody with few buttons: whatever is grown counts as uploaded at once.
class ASwitchboard : public testing::Test {
  protected:
    ASwitchboard() {
        configuration_.visit.rounds = 1;
        configuration_.visit.describe_words = 0;
        configuration_.take_home.url = "https://museum.example/";
    }
    void open() {
        show_.emplace(configuration_,
                      ShowOptions{base::Seed{1},
                                  {1, {65, 64, 128}},
                                  [] { return archive::WallTime{}; },
                                  [] { return archive::WallTime{}; },
                                  ""},
                      archive::Archive::open(folder_.path(), {}).archive);
        show_->open(now_);
        board_.emplace(configuration_, *show_);
        wait(100ms);
    }
    void wait(base::Instant time) {
        for (const base::Instant until = now_ + time; now_ < until; now_ += 20ms) {
            show_->finish_growing();
            if (show_->programme().waiting_for_upload() != nullptr) show_->uploaded(now_);
            show_->happen(exhibit::Tick{}, now_);
            board_->look(now_);
        }
    }
    void edge(Button button, Motion motion) { board_->take_edge({button, motion, now_}, now_); }
    void press(Button button) {
        edge(button, Motion::Down);
        wait(100ms);
        edge(button, Motion::Up);
        wait(400ms);
    }
    void until_marked(Choice choice) {
        for (int i = 0; i < 1000 && marked() != choice; ++i) wait(20ms);
    }
    std::optional<Choice> marked() const {
        const auto scanned = board_->scanned(now_);
        return scanned ? scanned->marked : std::nullopt;
    }
    std::string hint() const {
        const auto scanned = board_->scanned(now_);
        return scanned ? scanned->hint : "";
    }

    const tests::TemporaryFolder folder_;
    site::Configuration configuration_;
    base::Instant now_{1s};
    std::optional<Show> show_;
    std::optional<Switchboard> board_;
};

TEST_F(ASwitchboard, LightsTheLampOfWhatIsMarkedAndNoOther) {
    configuration_.play.buttons = "one";
    open();
    EXPECT_EQ(board_->lamps()[0], LampPattern::Breathing) << "any button will do";
    press(Button::C);
    for (const Choice choice : {Choice::A, Choice::B, Choice::D}) {
        until_marked(choice);
        const firmware_io::Lamps lamps = board_->lamps();
        for (std::size_t i = 0; i < lamps.size(); ++i)
            EXPECT_EQ(lamps[i], i == static_cast<std::size_t>(choice) ? LampPattern::Steady : LampPattern::Off) << i;
    }
    press(Button::A);
    until_marked(Choice::Back);
    EXPECT_EQ(board_->lamps()[firmware_io::index_of(Button::Back)], LampPattern::Steady);
    wait(40s);
    EXPECT_EQ(hint(), "scan.rest");
    for (const LampPattern lamp : board_->lamps()) EXPECT_EQ(lamp, LampPattern::Breathing) << "any button begins anew";
}

TEST_F(ASwitchboard, SaysWhatToDoAndNothingToWhoHasFour) {
    open();
    EXPECT_EQ(hint(), "invite.one");
    press(Button::B);
    EXPECT_FALSE(board_->scanned(now_)) << "a short press is a press";
    EXPECT_EQ(board_->lamps()[0], LampPattern::Steady);
    configuration_.play.buttons = "two";
    wait(100ms);
    EXPECT_EQ(hint(), "scan.two") << "a change of the settings is taken over";
    configuration_.play.buttons = "one";
    wait(100ms);
    EXPECT_EQ(hint(), "scan.one");
    configuration_.play.dwell_s = 3;
    EXPECT_EQ(hint(), "scan.step");
    configuration_.play.buttons = "four";
    configuration_.play.hold_s = 0;
    for (wait(300s); show_->state().screen != Screen::Attract;) wait(1s);
    wait(100ms);
    EXPECT_FALSE(board_->scanned(now_)) << "nobody is invited to what nobody can have";
}

TEST_F(ASwitchboard, HoldingFillsUpAndThenEverythingWaitsLonger) {
    open();
    const auto usual = show_->timings().patience;
    edge(Button::D, Motion::Down);
    wait(500ms);
    EXPECT_FALSE(board_->scanned(now_));
    wait(1500ms);
    EXPECT_EQ(hint(), "hold.one");
    const float half = board_->scanned(now_)->hold;
    wait(1s);
    EXPECT_GT(board_->scanned(now_)->hold, half);
    wait(1100ms);
    edge(Button::D, Motion::Up);
    EXPECT_EQ(marked(), Choice::A);
    EXPECT_EQ(show_->timings().patience, 3 * usual);
    configuration_.visit.patience_s = 10;
    show_->follow(configuration_);
    EXPECT_EQ(show_->timings().patience, std::chrono::seconds(30)) << "and goes on doing so after a change of settings";
    for (wait(100s); show_->state().screen != Screen::Attract;) wait(1s);
    wait(100ms);
    EXPECT_EQ(show_->timings().patience, std::chrono::seconds(10));
    EXPECT_EQ(hint(), "invite.one");
}

TEST_F(ASwitchboard, WhatStaffHoldIsNotHeldHere) {
    open();
    edge(Button::A, Motion::Down);
    board_->let_go(now_);
    wait(9s);
    EXPECT_FALSE(marked()) << "its release never came, and it asks for nothing";
    EXPECT_FALSE(show_->state().held);
}

TEST_F(ASwitchboard, TheFinaleGrowsFromWhatItsCodeHolds) {
    configuration_.play.buttons = "two";
    open();
    press(Button::A);
    for (int i = 0; i < 3; ++i) {
        press(Button::A);
        press(Button::B);
    }
    wait(200ms);
    ASSERT_EQ(show_->state().screen, Screen::Finale);
    ASSERT_TRUE(show_->take_home().starts_with("https://museum.example/Q"));
    ASSERT_EQ(show_->on_stage().recipes.size(), 1U);
    EXPECT_EQ(genome::recipe_of_code(show_->take_home(), "test"), show_->on_stage().recipes.front());
}

}  // namespace
}  // namespace quadrat::kiosk
