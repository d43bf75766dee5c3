// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "genome/speech.hpp"
#include "stage/easel.hpp"

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;

// The four candidates of a visit that asks for the best trees, on a stage of 320 by 180.
class AStage : public testing::Test {
  protected:
    AStage() : easel_(320, 180), stage_(easel_.renderer(), configuration_) {
        const auto scene = nursery::grow(genome::random_recipe(base::Seed{1}), {65, 64, 128});
        const auto gpu = upload_now(easel_.renderer(), scene);
        for (int i = 0; i < 4; ++i) cast_.scenes.push_back({scene, gpu});
        state_.screen = exhibit::Screen::Ask;
    }
    render::Frame frame(base::Instant now) {
        return stage_.frame({state_, timings_, cast_, flash_, 0.5F, now, caption_, asked_ ? &*asked_ : nullptr, board_,
                             backdrop_, sign_, scanned_ ? &*scanned_ : nullptr},
                            easel_.display().begin_frame());
    }
    mesh::Image drawn(base::Instant now) {
        const render::Frame f = frame(now);
        easel_.renderer().draw(f);
        return easel_.renderer().read_pixels(f);
    }

    site::Configuration configuration_;
    Easel easel_;
    Stage stage_;
    exhibit::State state_;
    exhibit::Timings timings_;
    Cast cast_;
    std::optional<Flash> flash_;
    const Board* board_ = nullptr;
    const mesh::Image* backdrop_ = nullptr;
    std::string_view caption_, sign_;
    std::optional<Asked> asked_;
    std::optional<Scanned> scanned_;
};

TEST_F(AStage, ABoardCoversEverythingOrIsReadOverThePicture) {
    Board board{"Quadrat", {"one", "two", std::string(400, 'w')}, Board::Cover::All};
    board_ = &board;
    EXPECT_TRUE(frame(3s).views.empty());
    for (const render::Sign& sign : frame(3s).signs) {
        EXPECT_GE(sign.place.x, 0);
        EXPECT_GE(sign.place.y, 0);
        EXPECT_LE(sign.place.x + sign.place.width, 320);
        EXPECT_LE(sign.place.y + sign.place.height, 180);
    }
    board = {"Closed", {}, Board::Cover::Tint};
    EXPECT_EQ(frame(3s).views.size(), 4U);
    EXPECT_EQ(frame(3s).signs.size(), 2U) << "the board alone, and its ground";
}

TEST_F(AStage, AStripLiesInACornerBesideAllTheRest) {
    const std::size_t without = frame(3s).signs.size();
    const Board board{"", {"60 frames/s", "a GPU"}, Board::Cover::Strip};
    board_ = &board;
    const render::Frame with = frame(3s);
    EXPECT_EQ(with.views.size(), 4U);
    ASSERT_EQ(with.signs.size(), without + 4) << "two lines, each on its ground";
    for (std::size_t i = without; i < with.signs.size(); ++i) EXPECT_LT(with.signs[i].place.y, 180 / 4);
}

TEST_F(AStage, ASignForStaffLiesInACornerAndCoversNeitherTheViewsNorTheQuestion) {
    const std::size_t without = frame(3s).signs.size();
    sign_ = genome::prompt("xh", "settings");
    const render::Frame with = frame(3s);
    EXPECT_EQ(with.views.size(), 4U);
    ASSERT_EQ(with.signs.size(), without + 2) << "words, and their ground";
    const render::Rect ground = with.signs[without].place;
    EXPECT_EQ(ground.x + ground.width, 320);
    EXPECT_EQ(ground.y, 0);
    EXPECT_GT(ground.x, 320 / 2);
    EXPECT_LT(ground.height, 180 / 4);
    const Board board{"Quadrat", {"one"}, Board::Cover::All};
    board_ = &board;
    EXPECT_EQ(frame(3s).signs.size(), 3U) << "the service screen says more";
}

TEST_F(AStage, AnEarlierLandscapeStandsInForWhatHasNotGrown) {
    cast_.scenes.clear();
    state_.screen = exhibit::Screen::Attract;
    mesh::Image picture(32, 18, 4);
    std::fill(picture.bytes.begin(), picture.bytes.end(), std::uint8_t{200});
    backdrop_ = &picture;
    const render::Frame f = frame(3s);
    EXPECT_TRUE(f.views.empty());
    EXPECT_EQ(f.signs.front().place, (render::Rect{0, 0, 320, 180}));
    EXPECT_NEAR(drawn(3s).pixel(5, 5)[0], 200, 12);
}

TEST_F(AStage, ShowsFourWhileItAsksAndOneOtherwise) {
    EXPECT_EQ(frame(3s).views.size(), 4U);
    state_.screen = exhibit::Screen::Attract;
    EXPECT_EQ(frame(3s).views.size(), 1U);
    state_.screen = exhibit::Screen::Finale;
    EXPECT_EQ(frame(3s).views.size(), 1U);
    cast_.scenes.clear();
    EXPECT_TRUE(frame(3s).views.empty());
    EXPECT_FALSE(frame(3s).signs.empty()) << "the words are there before the first landscapes are";
}

TEST_F(AStage, CaptionsBreedAndTheFinaleAlone) {
    using exhibit::Screen;
    for (const exhibit::Screen screen : {exhibit::Screen::Ask, exhibit::Screen::Attract, exhibit::Screen::StillThere,
                                         exhibit::Screen::Breed, exhibit::Screen::Finale}) {
        state_.screen = screen;
        caption_ = "";
        const std::size_t plain = frame(3s).signs.size();
        caption_ = "tall trees";
        const bool has_caption = screen == exhibit::Screen::Breed || screen == exhibit::Screen::Finale;
        EXPECT_EQ(frame(3s).signs.size(), plain + (has_caption ? 1 : 0)) << static_cast<int>(screen);
    }
}

TEST_F(AStage, EveryButtonIsAcknowledgedOnTheNextFrameWhateverIsShown) {
    for (const auto screen : {exhibit::Screen::Ask, exhibit::Screen::Attract, exhibit::Screen::Breed,
                              exhibit::Screen::StillThere, exhibit::Screen::Finale}) {
        state_.screen = screen;
        state_.since = 5s;
        for (const auto button :
             {exhibit::Choice::A, exhibit::Choice::B, exhibit::Choice::C, exhibit::Choice::D, exhibit::Choice::Back}) {
            flash_.reset();
            const mesh::Image before = drawn(10s);
            flash_ = Flash{button, 10s};
            const mesh::Image pressed = drawn(10s);
            std::size_t changed = 0;
            for (std::size_t i = 0; i < before.bytes.size(); ++i)
                changed += std::abs(before.bytes[i] - pressed.bytes[i]) > 40 ? 1U : 0U;
            EXPECT_GT(changed, 200U) << static_cast<int>(screen) << " " << static_cast<int>(button);
            const mesh::Image later = drawn(11s);
            flash_.reset();
            EXPECT_EQ(later, drawn(11s)) << "it is gone a second later";
        }
    }
}

TEST_F(AStage, TheFourAreSeenFromTheSamePlaceInPlan) {
    const render::Frame f = frame(20s);
    for (const render::View& view : f.views) {
        EXPECT_EQ(view.camera.eye_m.x, f.views[0].camera.eye_m.x);
        EXPECT_EQ(view.camera.eye_m.z, f.views[0].camera.eye_m.z);
    }
}

TEST_F(AStage, CountsDownInTheSitesOwnWords) {
    configuration_.texts["still-there"] = "Noch da?";
    state_.screen = exhibit::Screen::StillThere;
    state_.since = 10s;
    EXPECT_EQ(words({state_, timings_, cast_, flash_, 0, 13s}, configuration_), "Noch da?  7");
}

TEST_F(AStage, LabelsTheFourButtonsBesideOneLandscape) {
    cast_.scenes.resize(1);
    for (const auto screen : {exhibit::Screen::Describe, exhibit::Screen::Slide}) {
        state_.screen = screen;
        asked_.reset();
        const std::size_t plain = frame(3s).signs.size();
        asked_ = Asked{"describe.sky", {"a", "b", "c", "d"}, std::nullopt};
        if (screen == exhibit::Screen::Slide) asked_->slider = ShownSlider{"dry", "wet", 0.75F};
        const render::Frame labelled = frame(3s);
        EXPECT_EQ(labelled.views.size(), 1U);
        EXPECT_EQ(labelled.signs.size(), plain + 4 * 3 + (asked_->slider ? 5U : 0U));
        for (const render::Sign& sign : labelled.signs) {
            EXPECT_GE(sign.place.x, 0);
            EXPECT_GE(sign.place.y, 0);
            EXPECT_LE(sign.place.x + sign.place.width, 320);
            EXPECT_LE(sign.place.y + sign.place.height, 180);
        }
    }
}

TEST_F(AStage, FindsRoomForTheLabelsOfEveryLanguage) {
    cast_.scenes.resize(1);
    state_.screen = exhibit::Screen::Describe;
    for (const std::string_view code : genome::language_codes())
        for (const genome::Word& word : genome::vocabulary()) {
            configuration_.visit.language = std::string(code);
            asked_ = Asked{fmt::format("describe.{}", name_of(word.aspect)), genome::language(code).answers(word.id),
                           std::nullopt};
            const render::Frame labelled = frame(3s);
            const std::size_t first = labelled.signs.size() - 12;
            const auto top = [&](std::size_t label) {
                const render::Rect& plate = labelled.signs[first + 3 * label].place;
                return plate.y + plate.height;
            };
            EXPECT_LE(top(2), labelled.signs[first].place.y) << code << " " << word.name << ": A stands on C";
            for (const render::Sign& sign : labelled.signs) {
                EXPECT_GE(sign.place.x, 0) << code << " " << word.name;
                EXPECT_LE(sign.place.x + sign.place.width, 320) << code << " " << word.name;
                EXPECT_LE(sign.place.y + sign.place.height, 180) << code << " " << word.name;
            }
        }
}

// Mean brightness of a picture's pixels within a place, and how much it differs from place to place.
double difference(const mesh::Image& one, const mesh::Image& other, const render::Rect& place) {
    double sum = 0;
    for (int y = place.y; y < place.y + place.height; ++y)
        for (int x = place.x; x < place.x + place.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::abs(one.pixel(x, one.height - 1 - y)[c] - other.pixel(x, other.height - 1 - y)[c]);
    return sum / (3.0 * place.width * place.height);
}

TEST_F(AStage, WhatIsMarkedIsFramedAndNothingElseChanges) {
    scanned_ = Scanned{{}, "scan.one"};
    const mesh::Image plain = drawn(3s);
    const auto places = quarters(320, 180);
    for (std::size_t marked = 0; marked < 4; ++marked) {
        scanned_->marked = static_cast<exhibit::Choice>(marked);
        const mesh::Image framed = drawn(3s);
        for (std::size_t i = 0; i < 4; ++i) {
            // Its outer edge, away from the badge and the plate in the middle.
            const render::Rect edge{places[i].x + places[i].width / 4, i < 2 ? 180 - 5 : 0, places[i].width / 2, 5};
            if (i == marked)
                EXPECT_GT(difference(plain, framed, edge), 30) << i;
            else
                EXPECT_EQ(difference(plain, framed, edge), 0) << i;
        }
    }
}

TEST_F(AStage, BackStandsBelowTheQuestionWhereItIsOfferedAndIsFramedInItsTurn) {
    scanned_ = Scanned{exhibit::Choice::A, "scan.one"};
    const std::size_t without = frame(3s).signs.size();
    scanned_->offers_back = true;
    const render::Frame with = frame(3s);
    ASSERT_EQ(with.signs.size(), without + 2) << "its word, and its ground";
    const render::Rect ground = with.signs[without].place;
    EXPECT_NEAR(ground.x + ground.width / 2, 160, 1);
    EXPECT_LT(ground.y + ground.height, 90);
    EXPECT_GT(ground.y, 0);
    scanned_->marked = exhibit::Choice::Back;
    const mesh::Image framed = drawn(3s);
    scanned_->marked.reset();
    EXPECT_GT(difference(framed, drawn(3s), {ground.x, ground.y - 4, ground.width, 4}), 30);
}

TEST_F(AStage, NowAndThenAGhostShowsHowItIsPlayedWhileNobodyIsThere) {
    state_.screen = exhibit::Screen::Attract;
    const std::size_t without = frame(3s).signs.size();
    const render::Frame with = frame(12s);
    EXPECT_EQ(with.signs.size(), without + 2 + 4 + 3)
        << "a ground, a question, four badges, a finger, its outline, its nail";
    for (const render::Sign& sign : with.signs) {
        EXPECT_GE(sign.place.x, 0);
        EXPECT_LE(sign.place.x + sign.place.width, 320);
        EXPECT_LE(sign.place.y + sign.place.height, 180);
    }
    configuration_.look.motion = "calm";
    EXPECT_EQ(frame(12s).signs.size(), without + 2 + 4 + 1) << "a ring";
    for (const render::Sign& sign : frame(9s).signs)
        for (const render::Sign& later : frame(10s).signs)
            if (sign.texture && sign.texture == later.texture) {
                EXPECT_EQ(sign.place, later.place) << "nothing moves";
            }
    state_.screen = exhibit::Screen::Ask;
    EXPECT_EQ(frame(12s).views.size(), 4U);
    state_.screen = exhibit::Screen::Attract;
    configuration_.play.shows_how = false;
    EXPECT_EQ(frame(12s).signs.size(), without);
}

TEST_F(AStage, LabelsAreFramedToo) {
    cast_.scenes.resize(1);
    state_.screen = exhibit::Screen::Describe;
    asked_ = Asked{"describe.sky", {"a", "b", "c", "d"}, std::nullopt};
    scanned_ = Scanned{{}, "scan.two", true};
    const std::size_t plain = frame(3s).signs.size();
    scanned_->marked = exhibit::Choice::D;
    EXPECT_GT(frame(3s).signs.size(), plain);
    for (const render::Sign& sign : frame(3s).signs) {
        EXPECT_GE(sign.place.x, 0);
        EXPECT_GE(sign.place.y, 0);
        EXPECT_LE(sign.place.x + sign.place.width, 320);
        EXPECT_LE(sign.place.y + sign.place.height, 180);
    }
}

TEST_F(AStage, AHeldButtonFillsABarInThePlateOfTheQuestion) {
    scanned_ = Scanned{{}, "hold.one", false, 0.01F};
    const mesh::Image begun = drawn(3s);
    scanned_->hold = 1;
    const mesh::Image done = drawn(3s);
    std::size_t lit = 0;
    for (std::size_t i = 0; i < done.bytes.size(); ++i) lit += done.bytes[i] > begun.bytes[i] + 60 ? 1U : 0U;
    EXPECT_GT(lit, 60U);
}

TEST_F(AStage, ALabelLightsUpInItsButtonsColour) {
    cast_.scenes.resize(1);
    state_.screen = exhibit::Screen::Describe;
    asked_ = Asked{"describe.sky", {"a", "b", "c", "d"}, std::nullopt};
    const std::size_t quiet = frame(3s).signs.size();
    flash_ = Flash{exhibit::Choice::C, 3s};
    EXPECT_EQ(frame(3s).signs.size(), quiet + 2) << "the label and the plate of the question";
}

}  // namespace
}  // namespace quadrat::stage
