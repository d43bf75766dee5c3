// SPDX-License-Identifier: Apache-2.0
#include "nursery/gallery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "genome/scene_code.hpp"
#include "genome/season.hpp"
#include "kiosk/show.hpp"
#include "support/process.hpp"

namespace quadrat::kiosk {
namespace {

using namespace std::chrono_literals;
using exhibit::Screen;

nursery::Act finale(std::uint64_t seed) {
    nursery::Act act;
    act.scenes = {std::make_shared<const scene::Scene>()};
    act.recipes = {genome::random_recipe(base::Seed{seed})};
    act.number = static_cast<int>(seed);
    return act;
}

TEST(Gallery, TheNewestComesFirstAndTheOldestGo) {
    nursery::Gallery gallery;
    std::vector<nursery::Act> acts;
    for (std::uint64_t n = 1; n <= 5; ++n) {
        acts.push_back(finale(n));
        gallery.hang(acts.back());
    }
    EXPECT_EQ(gallery.act().scenes, (nursery::Scenes{acts[4].scenes[0], acts[3].scenes[0], acts[2].scenes[0]}));
    EXPECT_EQ(gallery.act().number, 5);
    EXPECT_FALSE(gallery.missing());
}

TEST(Gallery, WhatWentComesBackInItsOrder) {
    nursery::Gallery gallery;
    gallery.make_room();
    EXPECT_TRUE(gallery.act().scenes.empty());
    EXPECT_FALSE(gallery.missing());
    const nursery::Act first = finale(1);
    const nursery::Act second = finale(2);
    gallery.hang(first);
    gallery.hang(second);
    gallery.make_room();
    EXPECT_EQ(gallery.act().scenes, second.scenes);
    const nursery::Act third = finale(3);
    gallery.hang(third);
    EXPECT_EQ(gallery.act().scenes, (nursery::Scenes{third.scenes[0], second.scenes[0]}));
    ASSERT_TRUE(gallery.missing());
    EXPECT_EQ(*gallery.missing(), first.recipes[0]);
    gallery.bring_back(first.recipes[0], first.scenes[0]);
    EXPECT_EQ(gallery.act().scenes, (nursery::Scenes{third.scenes[0], second.scenes[0], first.scenes[0]}));
    EXPECT_FALSE(gallery.missing());
}

TEST(Gallery, HangsWhatStaffChoseBesideTheNewestAndInTurn) {
    nursery::Gallery gallery;
    std::vector<nursery::Act> liked;
    nursery::Chosen chosen;
    for (std::uint64_t n = 11; n <= 15; ++n) {
        liked.push_back(finale(n));
        chosen.favourites.push_back(liked.back().recipes[0]);
    }
    gallery.choose(chosen);
    ASSERT_EQ(gallery.missing(), liked[0].recipes[0]) << "before anybody has bred anything";
    for (std::size_t i = 0; i < nursery::Gallery::kMost; ++i)
        gallery.bring_back(*gallery.missing(), liked[i].scenes[0]);
    EXPECT_FALSE(gallery.missing());
    gallery.make_room();
    EXPECT_TRUE(gallery.act().scenes.empty()) << "none of them is the last finale, whose room costs nothing";
    const nursery::Act bred = finale(1);
    gallery.hang(bred);
    EXPECT_EQ(gallery.act().scenes, bred.scenes);
    for (const std::size_t next : {2U, 3U}) {
        ASSERT_EQ(gallery.missing(), liked[next].recipes[0]) << "the next two, in turn";
        gallery.bring_back(liked[next].recipes[0], liked[next].scenes[0]);
    }
    EXPECT_FALSE(gallery.missing());
    gallery.bring_back(liked[4].recipes[0], liked[4].scenes[0]);
    EXPECT_EQ(gallery.act().scenes.size(), nursery::Gallery::kMost) << "nobody waits for that one";
    chosen.favourites.clear();
    gallery.choose(chosen);
    EXPECT_EQ(gallery.act().scenes, bred.scenes);
}

TEST(Gallery, LetsAYearPassOverTheFirst) {
    nursery::Gallery gallery;
    gallery.choose({.favourites = {}, .hidden = {}, .shows_year = true});
    EXPECT_FALSE(gallery.missing()) << "of nothing there are no seasons";
    const nursery::Act first = finale(1), second = finale(2);
    gallery.hang(first);
    gallery.hang(second);
    const auto rest = genome::rest_of_year(second.recipes[0]);
    for (const genome::Recipe& season : rest) {
        ASSERT_EQ(gallery.missing(), season) << "behind what visitors bred";
        gallery.bring_back(season, std::make_shared<const scene::Scene>());
    }
    EXPECT_FALSE(gallery.missing());
    EXPECT_EQ(gallery.act().scenes.size(), 5U);
    EXPECT_EQ(gallery.recipes()[1], first.recipes[0]);
    gallery.make_room();
    EXPECT_EQ(gallery.act().scenes, second.scenes) << "a visitor's landscapes need the room";
    gallery.choose({});
    EXPECT_EQ(*gallery.missing(), first.recipes[0]);
}

TEST(Gallery, NeverHangsWhatStaffHideAndShowsWhatCameBefore) {
    nursery::Gallery gallery;
    std::vector<nursery::Act> acts;
    for (std::uint64_t n = 1; n <= 5; ++n) {
        acts.push_back(finale(n));
        gallery.hang(acts.back());
    }
    nursery::Chosen chosen;
    chosen.hidden = {genome::code_of(acts[4].recipes[0]), genome::code_of(acts[2].recipes[0])};
    chosen.favourites = {acts[2].recipes[0]};
    gallery.choose(chosen);
    EXPECT_EQ(gallery.act().scenes, acts[3].scenes) << "the others grow again";
    ASSERT_EQ(gallery.missing(), acts[1].recipes[0]);
    gallery.bring_back(acts[1].recipes[0], acts[1].scenes[0]);
    ASSERT_EQ(gallery.missing(), acts[0].recipes[0]);
    gallery.make_room();
    EXPECT_EQ(gallery.act().scenes, acts[3].scenes) << "the newest that is shown";
}

// The exhibit without a screen: whatever is grown counts as uploaded a frame later.
class Visits : public testing::Test {
  protected:
    Visits() {
        configuration_.visit.rounds = 2;  // after one they are much alike; the seed's four visits are not
        configuration_.visit.describe_words = 0;
        configuration_.visit.finale_s = 10;
        show_.emplace(configuration_,
                      ShowOptions{base::Seed{3},
                                  {1, {65, 64, 128}},
                                  [] { return archive::WallTime{}; },
                                  [] { return archive::WallTime{}; },
                                  ""},
                      archive::Archive::open(folder_.path(), {}).archive);
        show_->open(now_);
        settle();
    }

    void frame() {
        now_ += 100ms;
        show_->happen(exhibit::Tick{}, now_);
        show_->finish_growing();
        if (show_->programme().waiting_for_upload() != nullptr)
            show_->uploaded(now_);
        else if (show_->programme().waiting_to_refine() != nullptr)
            show_->programme().note_refined();
    }
    void settle() {
        for (int i = 0; i < 40; ++i) frame();
    }
    void press(exhibit::Choice button = exhibit::Choice::A) {
        show_->happen(exhibit::Pressed{button}, now_);
        frame();
        show_->happen(exhibit::Released{button}, now_);
        for (int i = 0; i < 10; ++i) frame();
    }
    // To the finale of a visit, which is given.
    std::shared_ptr<const scene::Scene> breed() {
        press();
        EXPECT_EQ(show_->state().screen, exhibit::Screen::Ask);
        // Every visitor likes something else: of two that are alike one alone is kept.
        const auto liked = static_cast<exhibit::Choice>(visits_++ % 4);
        for (int i = 0; i < 100 && show_->state().screen != exhibit::Screen::Finale; ++i) press(liked);
        EXPECT_EQ(show_->state().screen, exhibit::Screen::Finale);
        settle();
        return show_->on_stage().scenes.at(0);
    }
    std::shared_ptr<const scene::Scene> play() {
        const auto bred = breed();
        for (int i = 0; i < 600 && show_->state().screen != exhibit::Screen::Attract; ++i) frame();
        EXPECT_EQ(show_->state().screen, exhibit::Screen::Attract);
        return bred;
    }
    const nursery::Act& gallery() const { return show_->programme().gallery(); }

    tests::TemporaryFolder folder_;
    site::Configuration configuration_;
    base::Instant now_{0};
    int visits_ = 0;
    std::optional<Show> show_;
};

TEST_F(Visits, MakeRoomAndWhatTheyBredGrowsAgainAfterThem) {
    std::map<std::string, std::shared_ptr<const scene::Scene>> bred;
    for (std::size_t visit = 0; visit < 4; ++visit) {
        const auto scene = play();
        const std::string newest = genome::code_of(show_->programme().act_of(exhibit::Screen::Finale).recipes[0]);
        bred[newest] = scene;
        settle();
        std::vector<std::string> due{newest};
        for (const genome::Recipe& recipe : show_->programme().collection().ranked())
            if (genome::code_of(recipe) != newest) due.push_back(genome::code_of(recipe));
        ASSERT_EQ(due.size(), visit + 1) << "none is like another";
        due.resize(std::min(due.size(), nursery::Gallery::kMost));
        const auto rest = genome::rest_of_year(show_->recipes_on_stage()[0]);
        ASSERT_EQ(show_->on_stage().scenes.size(), due.size() + rest.size());
        for (std::size_t i = 0; i < rest.size(); ++i)
            EXPECT_EQ(show_->recipes_on_stage()[due.size() + i], rest[i]) << "then the rest of the newest one's year";
        for (std::size_t i = 0; i < due.size(); ++i) {
            ASSERT_EQ(genome::code_of(show_->recipes_on_stage()[i]), due[i]) << "the newest, then the worthiest";
            const scene::Scene& shown = *show_->on_stage().scenes[i];
            EXPECT_EQ(shown.light.ground, bred[due[i]]->light.ground) << "the same, in full light: " << i;
            EXPECT_EQ(shown.plants.size(), bred[due[i]]->plants.size());
            EXPECT_EQ(shown.exposure, bred[due[i]]->exposure);
        }
        press();
        EXPECT_EQ(gallery().scenes.size(), 1) << "a visit needs the room";
        EXPECT_EQ(show_->on_stage().scenes.size(), genome::kCandidates);
        for (int i = 0; i < 2000 && show_->state().screen != exhibit::Screen::Attract; ++i) frame();  // they walk away
    }
}

TEST_F(Visits, AreNotKeptWaitingByWhatGrowsForTheGallery) {
    play();
    play();
    breed();
    for (int i = 0; i < 2000 && show_->state().screen != exhibit::Screen::Attract; ++i) {
        now_ += 10ms;
        show_->happen(exhibit::Tick{}, now_);
    }
    constexpr std::size_t kAll = nursery::Gallery::kMost + 3;  // with the newest one's other seasons
    ASSERT_LT(gallery().scenes.size(), kAll) << "not all are back yet";
    ASSERT_TRUE(show_->programme().is_growing());
    const auto bred = play();
    settle();
    ASSERT_EQ(show_->on_stage().scenes.size(), kAll);
    EXPECT_EQ(show_->on_stage().scenes[0]->light.ground, bred->light.ground);
}

}  // namespace
}  // namespace quadrat::kiosk
