// SPDX-License-Identifier: Apache-2.0
#include "hearing/narrator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "genome/speech.hpp"
#include "hearing/handset.hpp"

namespace quadrat::hearing {
namespace {

using namespace std::chrono_literals;
using exhibit::Choice;
using exhibit::Screen;
using sound::Signal;
using testing::ElementsAre;
using testing::HasSubstr;

// In words, so that a test reads as it sounds.
std::vector<std::string> told(const std::vector<Cue>& cues) {
    constexpr const char* kSignals[] = {"press", "back", "mark", "choice", "round", "finale", "still there"};
    std::vector<std::string> words;
    for (const Cue& cue : cues) {
        if (const auto* says = std::get_if<Says>(&cue)) words.push_back(says->utterance.text);
        if (const auto* sounds = std::get_if<sound::Sounds>(&cue))
            words.push_back(std::string("*") + kSignals[static_cast<std::size_t>(sounds->signal)] + " " +
                            std::to_string(sounds->place));
        if (std::holds_alternative<Hushes>(cue)) words.emplace_back("-");
    }
    return words;
}

class ANarrator : public testing::Test {
  protected:
    ANarrator() {
        visit_.since = 1s;
        for (auto& one : four_) one = genome::Description{};
        four_[0]->set(genome::WordId::tall, 0.9F);
        four_[1]->set(genome::WordId::tall, -0.9F);
        four_[2]->set(genome::WordId::leafy, 0.9F);
        four_[3]->set(genome::WordId::sparse, 0.9F);
        look();
    }
    Subject subject() const {
        Subject subject{visit_, now_, "en", key_of(exhibit::prompt_of(visit_))};
        if (!prompt_.empty()) subject.prompt = prompt_;
        subject.four = four_;
        subject.labels = labels_;
        subject.label_languages = label_languages_;
        subject.caption = caption_;
        subject.pressed = pressed_;
        subject.pressed_at = pressed_at_;
        subject.is_marking = is_marking_;
        subject.marked = marked_;
        subject.hint = hint_;
        return subject;
    }
    std::vector<std::string> look() { return told(narrator_.look(subject())); }
    // A moment later.
    std::vector<std::string> show(Screen screen) {
        now_ += 20ms;
        visit_.screen = screen;
        visit_.since = now_;
        return look();
    }
    std::vector<std::string> mark(std::optional<Choice> choice) {
        now_ += 20ms;
        marked_ = choice;
        return look();
    }
    void press(Choice choice) {
        now_ += 1s;
        pressed_ = choice;
        pressed_at_ = now_;
    }

    site::Configuration configuration_;
    exhibit::State visit_;
    base::Instant now_{10s}, pressed_at_{0};
    std::array<std::optional<genome::Description>, 4> four_;
    std::array<std::string, 4> labels_, label_languages_;
    std::string caption_, prompt_, hint_;
    std::optional<Choice> pressed_, marked_;
    bool is_marking_ = false;
    Narrator narrator_{configuration_};
};

TEST_F(ANarrator, SaysTheQuestionTheFourAndOnceHowToHearItAgain) {
    EXPECT_THAT(show(Screen::Ask),
                ElementsAre("Which has the best trees?", "A: very tall trees", "B: very low trees",
                            "C: very leafy trees", "D: very scattered trees", "Hold Back down to hear it again"));
    EXPECT_TRUE(look().empty()) << "and not in every frame";
    visit_.question = genome::Aspect::Land;
    EXPECT_THAT(show(Screen::Ask), ElementsAre("-", "Which has the best land?", "A: easy land", "B: easy land",
                                               "C: easy land", "D: easy land"));
    show(Screen::Attract);
    visit_.question = genome::Aspect::Trees;
    EXPECT_EQ(show(Screen::Ask).back(), "Hold Back down to hear it again") << "the next visitor does not know";
}

TEST_F(ANarrator, SpeaksTheVisitorsLanguageInTheSitesOwnWords) {
    configuration_.texts = {{"ask.trees", "Pick a tree"}};
    EXPECT_EQ(show(Screen::Ask).front(), "Pick a tree");
    Subject german = subject();
    german.language = "de";
    visit_.since = now_ += 20ms;
    const std::vector<Cue> cues = narrator_.look(german);
    const auto& says = std::get<Says>(cues.at(2));
    EXPECT_EQ(says.utterance.language, "de");
    EXPECT_EQ(says.utterance.text, "A: sehr hohe Bäume");
    EXPECT_EQ(std::get<Says>(cues.at(1)).utterance.key, "ask.trees") << "what it may be recorded under";
}

TEST_F(ANarrator, NamesEachLanguageInThatLanguage) {
    prompt_ = "ask.language";
    labels_ = {"English", "Deutsch", "", ""};
    label_languages_ = {"en", "de", "", ""};
    now_ += 1s;
    visit_.screen = Screen::Language;
    visit_.since = now_;
    const std::vector<Cue> cues = narrator_.look(subject());
    EXPECT_THAT(told(cues), ElementsAre("Which language?", "A: English", "B: Deutsch"));
    EXPECT_EQ(std::get<Says>(cues[2]).utterance.language, "de");
}

TEST_F(ANarrator, IsSilencedByAPressAndSoundsIt) {
    show(Screen::Ask);
    press(Choice::C);
    EXPECT_THAT(look(), ElementsAre("-", "*press 2")) << "nothing was answered";
    press(Choice::C);
    visit_.question = genome::Aspect::Land;
    visit_.since = now_;
    EXPECT_THAT(look(), testing::IsSupersetOf({"*press 2", "*choice 2", "Which has the best land?"}));
    press(Choice::Back);
    EXPECT_THAT(look(), ElementsAre("-", "*back 4"));
}

TEST_F(ANarrator, SoundsTheNextFourAndTheFinaleAndAsksWhoIsThere) {
    show(Screen::Ask);
    caption_ = "taller";
    visit_.after_breed = Screen::Ask;
    EXPECT_THAT(show(Screen::Breed), ElementsAre("-", "taller"));
    visit_.rounds = 1;
    EXPECT_THAT(show(Screen::Ask), testing::Contains("*round 0"));
    EXPECT_THAT(show(Screen::StillThere), ElementsAre("-", "*still there 0", "Still there? Press any button"));
    EXPECT_THAT(show(Screen::Ask), testing::Not(testing::Contains("*round 0"))) << "they are the same four";
    caption_ = "wild land";
    visit_.after_breed = Screen::Finale;
    EXPECT_THAT(show(Screen::Breed), ElementsAre("-"));
    EXPECT_THAT(show(Screen::Finale), ElementsAre("*finale 0", "This is the landscape you bred", "wild land"));
}

TEST_F(ANarrator, DescribesWhatIsMarkedAndWaitsForNothingElse) {
    is_marking_ = true;
    hint_ = "scan.one";
    EXPECT_THAT(show(Screen::Ask),
                ElementsAre("Which has the best trees?", "Press any button when the frame is on yours"));
    EXPECT_THAT(mark(Choice::A), ElementsAre("*mark 0", "A: very tall trees"));
    const base::Instant until = narrator_.speaks_until();
    EXPECT_GT(until, now_ + 4s) << "question, how, and A";
    now_ = until - 100ms;
    EXPECT_EQ(narrator_.described(now_), 0U);
    now_ = until + 100ms;
    EXPECT_FALSE(narrator_.described(now_));
    EXPECT_THAT(mark(Choice::Back), ElementsAre("*mark 4", "← Back"));
    hint_ = "scan.rest";
    EXPECT_THAT(mark(std::nullopt), ElementsAre("Press any button to begin"));
    hint_ = "scan.one";
    EXPECT_THAT(mark(Choice::A), ElementsAre("Press any button when the frame is on yours", "Which has the best trees?",
                                             "*mark 0", "A: very tall trees"))
        << "who comes back to it has forgotten what was asked";
}

TEST_F(ANarrator, InvitesNobodyAloudAllDay) {
    hint_ = "invite.one";
    EXPECT_TRUE(show(Screen::Attract).empty());
    EXPECT_TRUE(look().empty());
    hint_ = "hold.one";
    EXPECT_THAT(look(), ElementsAre("Keep holding: then one button is enough"));
}

TEST_F(ANarrator, SaysWhichWayASliderTurns) {
    prompt_ = "slide";
    labels_ = {"", "", "dry", "wet"};
    EXPECT_THAT(show(Screen::Slide), ElementsAre("Turn one word after another until you like it", "C: dry", "D: wet",
                                                 "Hold Back down to hear it again"));
    visit_.slider = 1;
    labels_ = {"", "", "flat", "mountainous"};
    EXPECT_THAT(look(), ElementsAre("-", "C: flat", "D: mountainous"));
    is_marking_ = true;
    EXPECT_THAT(mark(Choice::B), ElementsAre("*mark 1", "B"));
}

TEST_F(ANarrator, SaysItAgainAndIsSilentWhenAsked) {
    show(Screen::Ask);
    EXPECT_THAT(told(narrator_.hush(now_)), ElementsAre("-"));
    EXPECT_LE(narrator_.speaks_until(), now_);
    EXPECT_TRUE(narrator_.hush(now_).empty());
    EXPECT_THAT(told(narrator_.repeat(subject())),
                ElementsAre("Which has the best trees?", "A: very tall trees", "B: very low trees",
                            "C: very leafy trees", "D: very scattered trees"));
    caption_ = "wild land";
    show(Screen::Finale);
    EXPECT_THAT(told(narrator_.repeat(subject())), ElementsAre("-", "This is the landscape you bred", "wild land"));
}

TEST(KeysOfQuestions, AreKeysThatEveryLanguageHas) {
    using exhibit::Prompt;
    for (const Prompt prompt : {Prompt::PressAnyButton, Prompt::BestTrees, Prompt::BestLand, Prompt::BestSky,
                                Prompt::Growing, Prompt::StillThere, Prompt::YourLandscape, Prompt::WhichLanguage})
        EXPECT_FALSE(genome::prompt("fr", key_of(prompt)).empty());
    EXPECT_EQ(key_of(Prompt::WhichWords), "");
}

TEST(AHandset, TellsAShortPressFromAWishToHearItAgainAndLouder) {
    Handset handset;
    EXPECT_FALSE(handset.next_deadline());
    handset.press(10s);
    EXPECT_EQ(handset.next_deadline(), base::Instant(11s));
    EXPECT_FALSE(handset.look(10'900ms));
    EXPECT_TRUE(handset.release(10'950ms)) << "it is Back";
    EXPECT_FALSE(handset.release(10'960ms)) << "nothing was down";
    handset.press(20s);
    EXPECT_EQ(handset.look(21s), Handset::Wish::Repeat);
    EXPECT_FALSE(handset.look(22s));
    EXPECT_EQ(handset.look(22'500ms), Handset::Wish::Louder);
    EXPECT_EQ(handset.look(24s), Handset::Wish::Louder);
    EXPECT_FALSE(handset.release(24'100ms)) << "that was no Back";
    handset.press(30s);
    EXPECT_FALSE(handset.release(31'500ms)) << "too long for Back, though nobody looked";
    handset.press(40s);
    handset.let_go();
    EXPECT_FALSE(handset.look(50s));
}

}  // namespace
}  // namespace quadrat::hearing
