// SPDX-License-Identifier: Apache-2.0
// What a show learns at night from those who described what they bred, and what it takes up again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "breeding/words/questions.hpp"
#include "kiosk/show.hpp"
#include "learning/past_visits.hpp"
#include "support/process.hpp"
#include "unit/learning/answers.hpp"

namespace quadrat::kiosk {
namespace {

using namespace learning;
using archive::WallTime;
using genome::Aspect;
using genome::WordId;
using namespace std::chrono_literals;

const archive::WallTime kNoon{std::chrono::sys_days{std::chrono::year{2031} / 2 / 3} + 12h};

// An exhibit on a small land, with clocks to turn.
class ShowAtNight : public testing::Test {
  protected:
    ShowAtNight() {
        configuration_.visit.rounds = 1;
        configuration_.visit.describe_every = 1;
    }
    std::unique_ptr<Show> opened() {
        ShowOptions options;
        options.seed = base::Seed{4};
        options.growing = {1, {65, 64, 128}};
        options.wall_time = [] { return kNoon; };
        options.local_time = [this] { return local_; };
        options.state = folder_.path();
        auto show =
            std::make_unique<Show>(configuration_, options, archive::Archive::open(folder_.path(), kNoon).archive);
        show->open(now_);
        settle(*show);
        return show;
    }
    void settle(Show& show) {
        show.finish_growing();
        if (show.programme().waiting_for_upload() != nullptr) show.uploaded(now_);
        show.happen(exhibit::Tick{}, now_);
    }
    void press(Show& show, exhibit::Choice button) {
        now_ += 2s;
        show.happen(exhibit::Pressed{button}, now_);
        show.happen(exhibit::Released{button}, now_);
        settle(show);
    }
    void visit_describing(Show& show, exhibit::Choice answer) {
        using exhibit::Choice;
        for (const exhibit::Choice button :
             {exhibit::Choice::A, exhibit::Choice::A, exhibit::Choice::B, exhibit::Choice::C})
            press(show, button);
        ASSERT_EQ(show.state().screen, exhibit::Screen::Finale);
        press(show, exhibit::Choice::D);  // on, from what the finale offers
        for (int word = 0; word < configuration_.visit.describe_words; ++word) {
            ASSERT_EQ(show.state().screen, exhibit::Screen::Describe);
            ASSERT_TRUE(show.asked());
            EXPECT_TRUE(show.asked()->prompt.starts_with("describe."));
            press(show, answer);
        }
        ASSERT_EQ(show.state().screen, exhibit::Screen::Attract);
    }
    std::size_t taught() { return site_words(folder_.path()).lessons.visitors.size(); }

    tests::TemporaryFolder folder_;
    site::Configuration configuration_;
    archive::WallTime local_ = kNoon;
    base::Instant now_{0};
};

TEST_F(ShowAtNight, AsksForOneWordOfEachAspectAndKeepsTheAnswers) {
    auto show = opened();
    visit_describing(*show, exhibit::Choice::D);
    show.reset();  // all is kept
    const auto answers = archive::Archive::open(folder_.path(), kNoon).archive.word_answers().readable;
    ASSERT_EQ(answers.size(), 3U);
    std::set<Aspect> asked;
    for (const genome::WordAnswer& answer : answers) {
        EXPECT_EQ(answer.value(), 1);
        EXPECT_EQ(answer.scene, answers[0].scene);
        EXPECT_TRUE(answer.made_of);
        asked.insert(word(answer.word).aspect);
    }
    EXPECT_EQ(asked.size(), 3U);
}

// A finale that somebody looks at for long, as a frame after another would: what is left over grows.
TEST_F(ShowAtNight, AsksAboutOtherLandscapesWhereTheSiteHasItSo) {
    using exhibit::Choice;
    configuration_.visit.describe_others = true;
    std::vector<genome::Recipe> bred;
    for (int visit = 0; visit < 2; ++visit) {
        auto show = opened();
        for (const Choice button : {Choice::A, Choice::A, Choice::B, Choice::C}) press(*show, button);
        ASSERT_EQ(show->state().screen, exhibit::Screen::Finale);
        bred.push_back(show->recipes_on_stage().front());
        while (show->programme().is_growing() || show->programme().waiting_to_refine() != nullptr) {
            show->programme().note_refined();
            settle(*show);
        }
        press(*show, Choice::D);
        ASSERT_EQ(show->state().screen, exhibit::Screen::Describe);
        ASSERT_EQ(show->on_stage().scenes.size(), 1U);
        ASSERT_EQ(show->recipes_on_stage().size(), 1U);
        bred.push_back(show->recipes_on_stage().front());
        for (int word = 0; word < configuration_.visit.describe_words; ++word) press(*show, Choice::D);
        ASSERT_EQ(show->state().screen, exhibit::Screen::Attract);
        EXPECT_NE(show->recipes_on_stage().front(), bred.back());
    }
    const auto answers = archive::Archive::open(folder_.path(), kNoon).archive.word_answers().readable;
    ASSERT_EQ(answers.size(), 6U);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const genome::WordAnswer& answer = answers[i];
        EXPECT_EQ(answer.scene, bred[i < 3 ? 1 : 3]);
        // The sequence goes on after a restart.
        const auto other = breeding::landscape_to_describe(site_words(folder_.path()).map, i < 3 ? 0 : 1, {});
        EXPECT_EQ(answer.made_of, other.words);
    }
    EXPECT_NE(bred[0], bred[1]);
}

TEST_F(ShowAtNight, AsksAboutWhatWasBredWhereTheOtherHasNotGrownYet) {
    using exhibit::Choice;
    configuration_.visit.describe_others = true;
    auto show = opened();
    for (const Choice button : {Choice::A, Choice::A, Choice::B, Choice::C}) press(*show, button);
    const genome::Recipe bred = show->recipes_on_stage().front();
    press(*show, Choice::D);
    ASSERT_EQ(show->state().screen, exhibit::Screen::Describe);
    for (int frame = 0; frame < 3; ++frame) {  // nor does it come in the midst of a question
        settle(*show);
        show->programme().note_refined();
        EXPECT_EQ(show->recipes_on_stage().front(), bred);
    }
}

TEST_F(ShowAtNight, SettingsMayChangeWhileItAsks) {
    auto show = opened();
    using exhibit::Choice;
    for (const exhibit::Choice button :
         {exhibit::Choice::A, exhibit::Choice::A, exhibit::Choice::B, exhibit::Choice::C, exhibit::Choice::D})
        press(*show, button);
    ASSERT_EQ(show->state().screen, exhibit::Screen::Describe);
    configuration_.visit.describe_words = 10;
    configuration_.visit.language = "de";
    configuration_.breeding.breeder = "sliders";  // holds from the next start
    show->follow(configuration_);
    for (int word = 0; word < 10; ++word) {
        ASSERT_EQ(show->state().screen, exhibit::Screen::Describe) << word;
        ASSERT_TRUE(show->asked());
        press(*show, exhibit::Choice::B);
    }
    EXPECT_EQ(show->state().screen, exhibit::Screen::Attract);
    press(*show, exhibit::Choice::A);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Ask);
}

TEST_F(ShowAtNight, TrainsAtItsStartAndEveryNightButNotByDay) {
    {
        archive::Archive archive = archive::Archive::open(folder_.path(), kNoon).archive;
        for (const auto& answer : sensible_answers(20).readable)
            EXPECT_EQ(archive.keep_word(answer, kNoon), std::nullopt);
    }
    auto show = opened();
    EXPECT_EQ(taught(), 20U) << "at its start";
    archive::Archive beside = archive::Archive::open(folder_.path(), kNoon).archive;
    for (const auto& answer : sensible_answers(30).readable) EXPECT_EQ(beside.keep_word(answer, kNoon), std::nullopt);
    local_ += 14h;  // two in the night
    settle(*show);
    EXPECT_EQ(taught(), 20U);
    local_ += 1h;
    settle(*show);  // is told
    settle(*show);  // has learnt
    EXPECT_EQ(taught(), 50U);
}

TEST_F(ShowAtNight, GoesOnWithAnInterruptedVisitThatBeganWithTheMapOfBefore) {
    auto show = opened();
    press(*show, exhibit::Choice::A);
    press(*show, exhibit::Choice::C);
    show.reset();  // the plug is pulled
    School school(folder_.path());
    ASSERT_TRUE(learn(school, sensible_answers(30)));
    testing::internal::CaptureStdout();
    show = opened();
    testing::internal::GetCapturedStdout();
    EXPECT_EQ(show->state().screen, exhibit::Screen::Ask);
    EXPECT_EQ(show->state().question, Aspect::Land);
}

TEST_F(ShowAtNight, GoesOnWithAVisitHoweverOftenItIsInterruptedForItHasTaughtNothingYet) {
    auto show = opened();
    press(*show, exhibit::Choice::A);
    press(*show, exhibit::Choice::C);
    for (int start = 0; start < 3; ++start) {
        show.reset();  // the plug is pulled
        EXPECT_EQ(last_visit_in(folder_.path()), 0);
        EXPECT_EQ(counted_taste(folder_.path()), breeding::Taste{});
        keep_site_taste(folder_.path(), counted_taste(folder_.path()));
        show = opened();
        EXPECT_EQ(show->state().screen, exhibit::Screen::Ask) << start;
        EXPECT_EQ(show->state().question, Aspect::Land) << start;
    }
}

TEST_F(ShowAtNight, GoesOnWithAnInterruptedVisitThatBeganWithTheTasteOfBefore) {
    auto show = opened();
    press(*show, exhibit::Choice::A);
    press(*show, exhibit::Choice::C);
    show.reset();  // the plug is pulled
    breeding::Taste taste;
    for (const Aspect aspect : genome::kAspects)
        taste.chosen[aspect][breeding::default_word_map().atlas(aspect).names.front()] = 200;
    keep_site_taste(folder_.path(), taste);
    EXPECT_EQ(previous_site_taste(folder_.path()), breeding::Taste{});
    show = opened();
    EXPECT_EQ(show->state().screen, exhibit::Screen::Ask);
    EXPECT_EQ(show->state().question, Aspect::Land);
}

TEST_F(ShowAtNight, AVisitIsOpenUntilItEndsOrAnotherBegins) {
    {
        archive::Archive archive = archive::Archive::open(folder_.path(), kNoon).archive;
        ASSERT_EQ(archive.begin_visit(kNoon).visit, 1);
        EXPECT_EQ(archive::open_visit_in(folder_.path()), 1);
        ASSERT_EQ(archive.begin_visit(kNoon).visit, 2);
        EXPECT_EQ(archive::open_visit_in(folder_.path()), 2);
        ASSERT_EQ(archive.end_visit(2, exhibit::Ending::Finished, 6, kNoon), std::nullopt);
    }
    EXPECT_EQ(archive::open_visit_in(folder_.path()), std::nullopt);
}

TEST_F(ShowAtNight, SlidersAreTurnedTakenBackAndTakenUpAfterAPowerCut) {
    configuration_.breeding.breeder = "sliders";
    auto show = opened();
    using exhibit::Choice;
    press(*show, exhibit::Choice::A);
    ASSERT_EQ(show->state().screen, exhibit::Screen::Slide);
    ASSERT_TRUE(show->asked() && show->asked()->slider);
    EXPECT_EQ(show->asked()->slider->share, 0.5F);
    EXPECT_EQ(show->on_stage().scenes.size(), 1U);
    const genome::Recipe before = show->on_stage().recipes.front();
    press(*show, exhibit::Choice::D);
    EXPECT_EQ(show->asked()->slider->share, 0.75F);
    const genome::Recipe turned = show->on_stage().recipes.front();
    EXPECT_NE(turned.values, before.values);
    EXPECT_EQ(turned.seeds, before.seeds);
    EXPECT_EQ(turned.flight, before.flight) << "seen from the same place";
    press(*show, exhibit::Choice::D);
    press(*show, exhibit::Choice::Back);
    EXPECT_EQ(show->on_stage().recipes.front(), turned);
    show.reset();  // the plug is pulled
    show = opened();
    EXPECT_EQ(show->state().screen, exhibit::Screen::Slide);
    EXPECT_EQ(show->on_stage().recipes.front(), turned);
    press(*show, exhibit::Choice::B);
    const std::string high = show->asked()->slider->high;
    EXPECT_EQ(high, genome::language("en").end(WordId::sparse, true));
    press(*show, exhibit::Choice::C);
    press(*show, exhibit::Choice::C);
    EXPECT_EQ(show->state().screen, exhibit::Screen::Finale) << "three actions are a round";
}

}  // namespace
}  // namespace quadrat::kiosk
