// SPDX-License-Identifier: Apache-2.0
// What is there before a visitor has answered everything, and what comes after it is on the screen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <thread>

#include "nursery/growing.hpp"
#include "nursery/plot.hpp"

namespace quadrat::nursery {
namespace {

using genome::Aspect;

const scene::Fineness kFine{65, 256, 256};
const base::Seed kFlight{31};

genome::Offer offer_of(std::uint64_t seed) {
    genome::Offer offer;
    for (std::size_t i = 0; i < offer.candidates.size(); ++i)
        offer.candidates[i] = genome::candidate_of(genome::random_recipe(base::Seed{seed}.child(i)));
    return offer;
}

Landscapes landscapes(const genome::Offer& offer) {
    return landscapes_of({offer.candidates.begin(), offer.candidates.end()}, kFlight);
}

std::vector<Want> awaited(const Landscapes& landscapes) {
    return wants_for(landscapes, Stage::FirstLight, Urgency::Awaited);
}

// Once trees and land were judged: they are known, and where plants stand.
std::vector<Want> two_known(const Landscapes& landscapes) {
    auto wants = wants_for(landscapes, Stage::Layout, Urgency::Coming);
    for (Want& want : wants) want.known[Aspect::Sky] = false;
    return wants;
}

Scenes found(const Nursery& nursery, const Landscapes& landscapes, bool is_full = false) {
    for (;;) {
        const auto lit = nursery.find(landscapes);
        if (lit && (lit->is_full || !is_full)) return lit->scenes;
        std::this_thread::yield();
    }
}

bool is_same(const scene::Scene& scene, const Landscape& landscape) {
    const auto at_once = grow(genome::recipe_of(landscape.candidate, kFlight), kFine);
    return scene.light.ground == at_once->light.ground && scene.exposure == at_once->exposure &&
           scene.sky->dome == at_once->sky->dome && scene.plants.size() == at_once->plants.size();
}

TEST(FirstLight, ComesFirstAndThenTheSceneAsItIs) {
    const Landscapes four = landscapes(offer_of(4));
    Nursery nursery({2, kFine});
    nursery.want(awaited(four));
    const Scenes first = found(nursery, four);
    EXPECT_LT(first.front()->light.ground.width, kFine.light_px);
    while (nursery.stock().is_busy) std::this_thread::yield();
    EXPECT_FALSE(nursery.find(four)->is_full) << "the cores are left to whoever brings it to the screen";
    nursery.want(wants_for(four, Stage::FullLight, Urgency::Shown));
    const Scenes full = found(nursery, four, true);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i]->land, full[i]->land);
        EXPECT_EQ(first[i]->flora, full[i]->flora);
        EXPECT_EQ(first[i]->sky, full[i]->sky);
        EXPECT_TRUE(is_same(*full[i], *four[i]));
    }
}

TEST(FirstLight, IsTheSameLightOnlyCoarser) {
    constexpr int kSeeds = 6;
    float mean_off = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const auto fine = grow(recipe, {129, 512, 256});
        const auto first = grow(recipe, first_light({129, 512, 256}));
        ASSERT_LT(first->light.ground.width, fine->light.ground.width);
        for (int c = 0; c < 3; ++c) {
            const auto mean = [c](const mesh::Image& image) {
                double sum = 0;
                for (std::size_t i = static_cast<std::size_t>(c); i < image.bytes.size(); i += 4) sum += image.bytes[i];
                return sum / (static_cast<double>(image.width) * image.height);
            };
            const double wanted = mean(fine->light.ground);
            EXPECT_NEAR(mean(first->light.ground), wanted, std::min(2.5, 1 + 0.06 * wanted)) << seed;
        }
        const float off = std::abs(first->exposure - fine->exposure) / fine->exposure;
        EXPECT_LT(off, 0.06F) << seed;  // a twelfth of a stop
        mean_off += off / kSeeds;
    }
    EXPECT_LT(mean_off, 0.03F);
}

TEST(FirstLight, IsLeftOutWhereNobodyCouldSeeIt) {
    const Landscapes four = landscapes(offer_of(5));
    Nursery nursery({2, {65, 64, 128}});
    nursery.want(awaited(four));
    EXPECT_EQ(found(nursery, four).front()->light.ground.width, 64);
    EXPECT_TRUE(nursery.find(four)->is_full);
}

TEST(FirstLight, WhoWaitsGetsTheSceneAsItIs) {
    const Landscapes four = landscapes(offer_of(6));
    Nursery nursery({2, kFine});
    nursery.want(awaited(four));
    nursery.wait();
    EXPECT_TRUE(nursery.find(four)->is_full);
    EXPECT_EQ(nursery.find(four)->scenes.front()->light.ground.width, kFine.light_px);
}

TEST(FirstLight, IsLeftOutOfWhatNobodyWaitsFor) {
    const Landscapes one{landscapes(offer_of(14)).front()};
    Nursery nursery({2, kFine});
    nursery.want(wants_for(one, Stage::FullLight, Urgency::Spare));
    EXPECT_EQ(found(nursery, one).front()->light.ground.width, kFine.light_px);
    EXPECT_TRUE(is_same(*nursery.find(one)->scenes.front(), *one.front()));
}

TEST(FirstLight, IsNotRefinedWhereSomethingElseIsAwaited) {
    const Landscapes first = landscapes(offer_of(7));
    const Landscapes next = landscapes(offer_of(8));
    Nursery nursery({2, kFine});
    nursery.want(awaited(first));
    found(nursery, first);
    nursery.want(wants_for(first, Stage::FullLight, Urgency::Shown));
    nursery.want(awaited(next));
    nursery.wait();
    EXPECT_FALSE(nursery.find(first));
    ASSERT_TRUE(nursery.find(next));
    EXPECT_TRUE(is_same(*nursery.find(next)->scenes.front(), *next.front()));
}

TEST(Ahead, WhatStandsIsKnownOnceTreesAndLandHaveGrownAndUntilItIsShown) {
    const Landscapes four = landscapes(offer_of(9));
    Nursery nursery({2, kFine});
    EXPECT_TRUE(nursery.ahead().grounds.empty());
    nursery.foresee([&] { return two_known(four); });
    while (nursery.ahead().grounds.size() < genome::kCandidates) std::this_thread::yield();
    const auto grounds = nursery.ahead().grounds;
    nursery.want(awaited(four));
    nursery.wait();
    EXPECT_EQ(nursery.ahead().grounds, grounds);
    const Scenes scenes = nursery.find(four)->scenes;
    nursery.want(wants_for(four, Stage::FullLight, Urgency::Shown));
    EXPECT_EQ(nursery.ahead().grounds, grounds);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_EQ(scenes[i]->flora, grounds[i].flora);
        EXPECT_EQ(scenes[i]->land, grounds[i].land);
        // Laid out ahead or at once: the same plants.
        const auto at_once = grow(genome::recipe_of(four[i]->candidate, kFlight), kFine);
        ASSERT_EQ(scenes[i]->plants.size(), at_once->plants.size());
        for (std::size_t p = 0; p < at_once->plants.size(); ++p)
            ASSERT_EQ(scenes[i]->plants[p].root_m, at_once->plants[p].root_m);
    }
    nursery.want({});
    EXPECT_TRUE(nursery.ahead().grounds.empty());
}

TEST(Ahead, AnotherAnswerLaysOutOthers) {
    const Landscapes one = landscapes(offer_of(10));
    const Landscapes other = landscapes(offer_of(11));
    Nursery nursery({2, kFine});
    for (const Landscapes& four : {one, other}) nursery.foresee([four] { return two_known(four); });
    while (nursery.ahead().grounds.size() < genome::kCandidates || nursery.stock().is_busy) std::this_thread::yield();
    nursery.want(awaited(other));
    nursery.wait();
    EXPECT_TRUE(is_same(*nursery.find(other)->scenes.back(), *other.back()));
}

TEST(Ahead, WhicheverOfTheFewThatCanComeIsAwaitedIsThereAtOnce) {
    const genome::Offer offer = offer_of(12);
    std::vector<Landscapes> possible;
    for (std::uint64_t answer = 0; answer < 4; ++answer) {
        genome::Offer with_sky = offer;
        const genome::Offer skies = offer_of(100 + answer);
        for (std::size_t i = 0; i < with_sky.candidates.size(); ++i) {
            for (const auto id : genome::parameters_of(Aspect::Sky, genome::Genome::Full))
                with_sky.candidates[i].values.set(id, skies.candidates[i].values[id]);
            with_sky.candidates[i].seeds[Aspect::Sky] = skies.candidates[i].seeds[Aspect::Sky];
        }
        possible.push_back(landscapes(with_sky));
    }
    Nursery nursery({2, kFine});
    nursery.foresee([&] {
        auto wants = two_known(possible.front());
        for (const Landscapes& four : possible)
            std::ranges::move(wants_for(four, Stage::FirstLight, Urgency::Coming), std::back_inserter(wants));
        return wants;
    });
    while (nursery.ahead().lit.size() < 16) std::this_thread::yield();
    const Scenes all = nursery.ahead().lit;
    nursery.want(awaited(possible[2]));
    ASSERT_TRUE(nursery.find(possible[2]));
    EXPECT_EQ(nursery.progress(), 1);
    const Scenes first = nursery.find(possible[2])->scenes;
    EXPECT_FALSE(nursery.find(possible[1])) << "it will not come";
    nursery.want(wants_for(possible[2], Stage::FullLight, Urgency::Shown));
    EXPECT_TRUE(nursery.ahead().lit.empty());
    const Scenes full = found(nursery, possible[2], true);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NE(std::ranges::find(all, first[i]), all.end());
        EXPECT_EQ(first[i]->sky, full[i]->sky);
        EXPECT_TRUE(is_same(*full[i], *possible[2][i]));
    }
}

TEST(Ahead, AnAnswerTakenBackForgetsWhatWasLitForIt) {
    const Landscapes four = landscapes(offer_of(13));
    Nursery nursery({2, kFine});
    nursery.foresee([&] {
        auto wants = two_known(four);
        std::ranges::move(wants_for(four, Stage::FirstLight, Urgency::Coming), std::back_inserter(wants));
        return wants;
    });
    while (nursery.ahead().lit.size() < 4) std::this_thread::yield();
    nursery.foresee([&] {
        auto wants = wants_for(four, Stage::Aspects, Urgency::Coming);
        for (Want& want : wants) want.known = {{true, false, false}};
        return wants;
    });
    while (nursery.stock().is_busy) std::this_thread::yield();
    EXPECT_TRUE(nursery.ahead().lit.empty());
    nursery.want(awaited(four));
    EXPECT_FALSE(nursery.find(four));
    nursery.wait();
    EXPECT_TRUE(nursery.find(four));
}

}  // namespace
}  // namespace quadrat::nursery
