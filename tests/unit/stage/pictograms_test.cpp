// SPDX-License-Identifier: Apache-2.0
#include "stage/pictograms.hpp"

#include <gtest/gtest.h>

#include <set>

#include "genome/speech.hpp"
#include "unit/stage/legible_stage.hpp"

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;

TEST_F(ALegibleStage, SaysWithPictogramsWhatItSaysInWordsOrSaysItWithThemAlone) {
    using exhibit::Screen;
    state_.past_answers = {genome::Pick{}};
    for (const char* size : kSizeNames)
        for (const Screen screen : {Screen::Attract, Screen::Ask, Screen::Breed, Screen::StillThere, Screen::Finale}) {
            configuration_.look.size = size;
            configuration_.look.pictograms = "none";
            const render::Frame words = frame(screen);
            configuration_.look.pictograms = "beside";
            const render::Frame beside = frame(screen);
            configuration_.look.pictograms = "alone";
            const render::Frame alone = frame(screen);
            EXPECT_EQ(beside.signs.size(), words.signs.size() + 1) << size;
            EXPECT_LE(alone.signs.size(), beside.signs.size());
            for (const render::Frame* drawn : {&words, &beside, &alone}) expect_within(*drawn, size);
        }
}

// But for what staff read.
TEST(Pictograms, SayEveryPromptWithoutWordsAndNoTwoQuestionsAlike) {
    std::set<std::vector<render::Pictogram>> of_questions;
    int questions = 0;
    for (const std::string_view key : genome::kPrompts) {
        const auto row = pictograms_for(key);
        EXPECT_EQ(row.empty(), key == "settings") << key;
        EXPECT_LE(row.size(), 3U) << key;
        if (!key.starts_with("ask.") && !key.starts_with("describe.")) continue;
        of_questions.insert({row.begin(), row.end()});
        ++questions;
    }
    EXPECT_EQ(of_questions.size(), static_cast<std::size_t>(questions));
    std::set<std::vector<render::Pictogram>> of_choices;
    for (const char* key : {"family", "go-on", "print", "printing", "done"}) {
        const auto row = pictograms_for(key);
        of_choices.insert({row.begin(), row.end()});
    }
    EXPECT_EQ(of_choices.size(), 5U);
    EXPECT_TRUE(pictograms_for("sea").empty());
}

TEST_F(ALegibleStage, WritesSomethingWhereThereIsNoRoomAtAll) {
    for (const char* words : {"", "Print a postcard"})
        for (const glm::ivec2 most : {glm::ivec2{-4, 20}, glm::ivec2{0, 0}, glm::ivec2{3, -1}}) {
            const auto written =
                stage_.writer().said_within(pictograms_for("printing"), words, 9, true, most, SignWriter::Begins::Left);
            EXPECT_GT(written.width, 0);
            EXPECT_GT(written.height, 0);
        }
}

// Two languages without a word of one width: what has the same places in both is no word.
TEST_F(ALegibleStage, ShowsNoWordWherePictogramsStandAlone) {
    using exhibit::Screen;
    timings_.can_print = timings_.can_breed_on = true;
    timings_.turns = exhibit::TakingTurns::Always;
    state_.family = family_of(3);
    state_.here = 3;
    const auto textures_of = [&](const std::string& language, Screen screen, const std::string& hint,
                                 base::Instant now) {
        configuration_.look.pictograms = "alone";
        configuration_.visit.language = language;
        state_.screen = screen;
        state_.finale_asks = screen == Screen::Finale;
        asked_ =
            screen == Screen::Finale ? asked_of(state_, timings_, Spoken(configuration_), std::nullopt) : std::nullopt;
        if (!hint.empty()) scanned_ = Scanned{exhibit::Choice::Back, hint, screen == Screen::Ask};
        std::vector<render::Rect> places;
        const render::Frame drawn = frame(screen, now);
        expect_within(drawn, language + " " + hint);
        for (const render::Sign& sign : drawn.signs)
            if (sign.texture) places.push_back(sign.place);
        return places;
    };
    for (const auto& [screen, now] : {std::pair{Screen::Attract, base::Instant{3s}},
                                      {Screen::Attract, base::Instant{9700ms}},
                                      {Screen::Ask, base::Instant{3s}},
                                      {Screen::Breed, base::Instant{3s}},
                                      {Screen::StillThere, base::Instant{3s}},
                                      {Screen::Finale, base::Instant{3s}}})
        for (const char* hint : {"invite.one", "scan.one", "scan.step", "scan.two", "hear.again"}) {
            const auto english = textures_of("en", screen, hint, now), japanese = textures_of("ja", screen, hint, now);
            ASSERT_EQ(english.size(), japanese.size());
            for (std::size_t i = 0; i < english.size(); ++i)
                EXPECT_TRUE(english[i] == japanese[i]) << static_cast<int>(screen) << " " << hint << " " << i;
        }
}

}  // namespace
}  // namespace quadrat::stage
