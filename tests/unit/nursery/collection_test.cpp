// SPDX-License-Identifier: Apache-2.0
#include "nursery/collection.hpp"

#include <gtest/gtest.h>

#include "genome/scene_code.hpp"
#include "nursery/gallery.hpp"
#include "nursery/wall.hpp"

namespace quadrat::nursery {
namespace {

using namespace std::chrono_literals;

// Works of different numbers say different words.
Work work(std::uint64_t number) {
    Work one;
    one.code = genome::code_of(genome::random_recipe(base::Seed{number}));
    one.recipe = genome::recipe_of_code(one.code, "test");  // as finales are: what their code holds
    base::RandomStream chance(base::Seed{number}.child("words"));
    one.words.emplace();
    for (const genome::Word& word : genome::vocabulary())
        one.words->set(word.id, static_cast<float>(2 * chance.unit() - 1));
    one.day = 20'000 + static_cast<std::int64_t>(number);
    return one;
}

Work like(const Work& other, std::uint64_t number) {
    Work one = work(number);
    one.words = other.words;
    one.words->set(genome::WordId::wet, (*other.words)[genome::WordId::wet] * 0.9F);
    return one;
}

TEST(Worth, IsWhoStaysAMinuteAndMoreForWhoBreedsOn) {
    Work fresh = work(1), passed = work(1), stopped = work(1), chosen = work(1);
    passed.shown_s = 600;
    stopped.shown_s = chosen.shown_s = 600;
    stopped.stays = chosen.stays = 5;
    chosen.chosen = 2;
    EXPECT_GT(worth(fresh), worth(passed)) << "a newcomer has the benefit of the doubt";
    EXPECT_GT(worth(stopped), worth(passed));
    EXPECT_GT(worth(chosen), worth(stopped));
    EXPECT_NEAR(worth(stopped), 6.0 / 12, 1e-9);
}

TEST(Collection, HoldsNoTwoThatAreAlikeAndKeepsTheWorthier) {
    Collection collection;
    collection.admit(work(1));
    collection.admit(like(work(1), 2));
    ASSERT_EQ(collection.works().size(), 1U);
    EXPECT_EQ(collection.works()[0].code, work(2).code) << "neither has shown its worth: the newer";
    collection.was_stopped_at(work(2).code, true);
    collection.admit(like(work(1), 3));
    ASSERT_EQ(collection.works().size(), 1U);
    EXPECT_EQ(collection.works()[0].code, work(2).code);
    collection.admit(work(4));
    EXPECT_EQ(collection.works().size(), 2U);
    for (std::size_t i = 0; i < collection.works().size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(are_alike(collection.works()[i], collection.works()[j]));
}

TEST(Collection, LetsTheLeastWorthyGoButNeverTheNewest) {
    Collection collection;
    for (std::uint64_t n = 1; n <= Collection::kMost; ++n) collection.admit(work(n));
    for (std::uint64_t n = 1; n <= Collection::kMost; ++n) collection.was_stopped_at(work(n).code, false);
    collection.was_shown(work(7).code, 3600);
    collection.admit(work(100));
    EXPECT_EQ(collection.works().size(), Collection::kMost);
    EXPECT_EQ(collection.find(work(7).code), nullptr);
    EXPECT_EQ(collection.works().front().code, work(100).code);
    EXPECT_EQ(collection.ranked().back(), work(100).recipe);
}

TEST(Collection, ComesBackFromItsTextAndLeavesOutWhatItCannotRead) {
    Collection collection;
    for (std::uint64_t n = 1; n <= 3; ++n) collection.admit(work(n));
    collection.was_shown(work(2).code, 12.5);
    collection.was_stopped_at(work(2).code, true);
    const std::string text = collection.to_json();
    EXPECT_EQ(Collection::from_json(text), collection);
    for (const char* wrong : {"", "{", "[]", "{\"version\":2,\"works\":[]}", "{\"version\":1}",
                              "{\"version\":1,\"works\":[{\"code\":\"Q\"}, 7, null]}"})
        EXPECT_TRUE(Collection::from_json(wrong).works().empty()) << wrong;
    std::string damaged = text;
    damaged.replace(damaged.find("\"shown_s\":12.5"), 14, "\"shown_s\":-1.0");
    EXPECT_EQ(Collection::from_json(damaged).works().size(), 2U);
}

Act finale(std::uint64_t number) {
    Act act;
    act.scenes = {std::make_shared<const scene::Scene>()};
    act.recipes = {work(number).recipe};
    act.number = static_cast<int>(number);
    return act;
}

Birth birth(std::uint64_t number, const std::string& parent = "") { return {work(number).words, 20'000, parent}; }

TEST(LivingGallery, CountsWhatWasShownAndWhoStayed) {
    Gallery gallery;
    gallery.hang(finale(1), birth(1));
    gallery.hang(finale(2), birth(2));
    gallery.open(100s);
    // The newest for 24 s, the other for 24 s, the newest again for 12 s.
    EXPECT_EQ(gallery.shown(160s), 0U);
    EXPECT_EQ(gallery.shown(130s), 1U);
    gallery.leave(160s, Gallery::Came::ToBreedOn);
    const Work* newest = gallery.collection().find(work(2).code);
    ASSERT_NE(newest, nullptr);
    EXPECT_DOUBLE_EQ(newest->shown_s, 36);
    EXPECT_DOUBLE_EQ(newest->stays, 1);
    EXPECT_DOUBLE_EQ(newest->chosen, 1);
    const Work* other = gallery.collection().find(work(1).code);
    EXPECT_DOUBLE_EQ(other->shown_s, 24);
    EXPECT_DOUBLE_EQ(other->stays, 0);
}

TEST(LivingGallery, HangsTheWorthiestBesideTheNewest) {
    Gallery gallery;
    for (std::uint64_t n = 1; n <= 5; ++n) gallery.hang(finale(n), birth(n));
    Collection earned = gallery.collection();
    earned.was_stopped_at(work(1).code, true);
    earned.was_stopped_at(work(3).code, false);
    Gallery after_a_night;
    after_a_night.recall(earned);
    std::vector<genome::Recipe> hung;
    while (const auto missing = after_a_night.missing()) {
        hung.push_back(*missing);
        after_a_night.bring_back(*missing, std::make_shared<const scene::Scene>());
    }
    EXPECT_EQ(hung, (std::vector{work(5).recipe, work(1).recipe, work(3).recipe}));
}

std::vector<genome::Recipe> hung_in(Gallery gallery) {
    while (const auto missing = gallery.missing()) gallery.bring_back(*missing, std::make_shared<const scene::Scene>());
    return {gallery.recipes().begin(), gallery.recipes().end()};
}

TEST(LivingGallery, HangsNoTwoThatAreAlike) {
    Gallery gallery;
    for (std::uint64_t n = 1; n <= 3; ++n) gallery.hang(finale(n), birth(n));
    Collection earned = gallery.collection();
    earned.was_stopped_at(work(1).code, true);
    Gallery later;
    later.recall(earned);
    // The newest is outdone by one that is like it: it hangs, as the newest does, and the other does not meanwhile.
    const Work twin = like(work(1), 7);
    later.hang(finale(7), {twin.words, 20'000, ""});
    ASSERT_EQ(later.collection().find(work(7).code), nullptr) << "outdone";
    EXPECT_EQ(hung_in(later), (std::vector{work(7).recipe, work(3).recipe, work(2).recipe}));
    // Nor where staff chose that other.
    later.choose({{work(1).recipe, work(2).recipe}, {}});
    EXPECT_EQ(hung_in(later), (std::vector{work(7).recipe, work(2).recipe, work(3).recipe}));
    later.choose({{work(1).recipe, work(2).recipe}, {work(7).code}});
    EXPECT_EQ(hung_in(later), (std::vector{work(3).recipe, work(1).recipe, work(2).recipe}));
}

TEST(LivingGallery, KnowsWhatWasBredFromWhat) {
    Gallery gallery;
    gallery.hang(finale(1), birth(1));
    gallery.hang(finale(2), birth(2, work(1).code));
    gallery.hang(finale(3), birth(3, work(2).code));
    const Work* third = gallery.collection().find(work(3).code);
    ASSERT_NE(third, nullptr);
    EXPECT_EQ(third->generation, 3);
    EXPECT_EQ(third->parent, work(2).code);
    EXPECT_EQ(gallery.collection().find(work(1).code)->generation, 1);
}

TEST(Wall, ShowsOneAfterTheOtherWithItsWordsAndReadsAnew) {
    std::vector<Work> works{work(1), work(2), work(3), work(4), work(5)};
    std::atomic<int> reads{0};
    Wall wall([&] {
        ++reads;
        return works;
    });
    Gallery gallery;
    base::Instant now{0};
    const auto frame = [&] {
        wall.look(gallery, now);
        if (const auto missing = gallery.missing())
            gallery.bring_back(*missing, std::make_shared<const scene::Scene>());
    };
    while (gallery.recipes().empty()) frame();
    const genome::Language& language = genome::language("en");
    for (std::uint64_t turn = 0; turn < 12; ++turn) {
        for (int i = 0; i < 10; ++i, now += 100ms) frame();
        const Work& shown = works[turn % works.size()];
        EXPECT_EQ(wall.caption(language), language.describe(*shown.words));
        EXPECT_EQ(wall.address("https://museum.example/"), "https://museum.example/" + shown.code);
        EXPECT_EQ(wall.address(""), "");
        now += Gallery::kShownFor - 1s;
    }
    for (now += Wall::kReadEvery; reads < 2;) frame();
}

}  // namespace
}  // namespace quadrat::nursery
