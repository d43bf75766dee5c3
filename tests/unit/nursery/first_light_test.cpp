// SPDX-License-Identifier: Apache-2.0
// What is there before a visitor has answered everything, and what comes after it is on the screen.
#include <gtest/gtest.h>

#include <algorithm>
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

std::vector<genome::Candidate> candidates_of(const genome::Offer& offer) {
    return {offer.candidates.begin(), offer.candidates.end()};
}

HeadStart head_start_of(const genome::Offer& offer) {
    return {{candidates_of(offer), kFlight}, {Aspect::Trees, Aspect::Land}, {}};
}

template <typename Take>
Scenes taken(const Take& take) {
    for (;;) {
        if (auto scenes = take()) return *scenes;
        std::this_thread::yield();
    }
}

TEST(FirstLight, ComesFirstAndThenTheSceneAsItIs) {
    const genome::Offer offer = offer_of(4);
    Grower grower({2, kFine});
    grower.order({candidates_of(offer), kFlight});
    const Scenes first = taken([&] { return grower.take(); });
    EXPECT_LT(first.front()->light.ground.width, kFine.light_px);
    EXPECT_FALSE(grower.stock().is_busy);  // the cores are left to whoever brings it to the screen
    EXPECT_TRUE(grower.is_refining());
    EXPECT_FALSE(grower.take_refined().has_value());
    grower.refine();
    const Scenes refined = taken([&] { return grower.take_refined(); });
    ASSERT_EQ(refined.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i]->land, refined[i]->land);
        EXPECT_EQ(first[i]->flora, refined[i]->flora);
        EXPECT_EQ(first[i]->sky, refined[i]->sky);
        const auto at_once = grow(genome::recipe_of(offer.candidates[i], kFlight), kFine);
        EXPECT_EQ(refined[i]->light.ground, at_once->light.ground);
        EXPECT_EQ(refined[i]->exposure, at_once->exposure);
    }
    EXPECT_FALSE(grower.take_refined().has_value());
    EXPECT_FALSE(grower.is_refining());
}

TEST(FirstLight, IsTheSameLightOnlyCoarser) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
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
        EXPECT_NEAR(first->exposure, fine->exposure, 0.03F * fine->exposure) << seed;
    }
}

TEST(FirstLight, IsLeftOutWhereNobodyCouldSeeIt) {
    Grower grower({2, {65, 64, 128}});
    grower.order({candidates_of(offer_of(5)), kFlight});
    const Scenes scenes = taken([&] { return grower.take(); });
    EXPECT_FALSE(grower.is_refining());
    EXPECT_EQ(scenes.front()->light.ground.width, 64);
}

TEST(FirstLight, WhoWaitsGetsTheSceneAsItIs) {
    Grower grower({2, kFine});
    grower.order({candidates_of(offer_of(6)), kFlight});
    grower.wait();
    EXPECT_EQ(grower.take()->front()->light.ground.width, kFine.light_px);
    EXPECT_FALSE(grower.take_refined().has_value());
}

TEST(FirstLight, AnOrderForgetsWhatWasToBeRefined) {
    Grower grower({2, kFine});
    grower.order({candidates_of(offer_of(7)), kFlight});
    taken([&] { return grower.take(); });
    const genome::Offer next = offer_of(8);
    grower.order({candidates_of(next), kFlight});
    grower.wait();
    const auto scenes = grower.take();
    ASSERT_TRUE(scenes.has_value());
    EXPECT_EQ(scenes->front()->light.ground,
              grow(genome::recipe_of(next.candidates.front(), kFlight), kFine)->light.ground);
    EXPECT_FALSE(grower.take_refined().has_value());
}

TEST(Ahead, WhatStandsIsKnownOnceTreesAndLandHaveGrownAndUntilItIsTaken) {
    const genome::Offer offer = offer_of(9);
    Grower grower({2, kFine});
    EXPECT_TRUE(grower.ahead().grounds.empty());
    grower.begin([&] { return head_start_of(offer); });
    while (grower.ahead().grounds.size() < genome::kCandidates) std::this_thread::yield();
    const auto grounds = grower.ahead().grounds;
    grower.order({candidates_of(offer), kFlight});
    grower.wait();
    EXPECT_EQ(grower.ahead().grounds, grounds);
    const Scenes scenes = *grower.take();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_EQ(scenes[i]->flora, grounds[i].flora);
        EXPECT_EQ(scenes[i]->land, grounds[i].land);
        // Laid out ahead or at once: the same plants.
        const auto at_once = grow(genome::recipe_of(offer.candidates[i], kFlight), kFine);
        ASSERT_EQ(scenes[i]->plants.size(), at_once->plants.size());
        for (std::size_t p = 0; p < at_once->plants.size(); ++p)
            ASSERT_EQ(scenes[i]->plants[p].root_m, at_once->plants[p].root_m);
    }
    EXPECT_TRUE(grower.ahead().grounds.empty());
}

TEST(Ahead, AnotherAnswerLaysOutOthers) {
    const genome::Offer one = offer_of(10);
    const genome::Offer other = offer_of(11);
    Grower grower({2, kFine});
    for (const genome::Offer& offer : {one, other}) grower.begin([offer] { return head_start_of(offer); });
    while (grower.ahead().grounds.size() < genome::kCandidates || grower.stock().is_busy) std::this_thread::yield();
    grower.order({candidates_of(other), kFlight});
    grower.wait();
    const Scenes scenes = *grower.take();
    const auto at_once = grow(genome::recipe_of(other.candidates.back(), kFlight), kFine);
    EXPECT_EQ(scenes.back()->plants.size(), at_once->plants.size());
    EXPECT_EQ(scenes.back()->light.ground, at_once->light.ground);
}

TEST(Ahead, WhicheverOfTheFewOrdersThatCanComeIsGivenIsReadyAtOnce) {
    const genome::Offer offer = offer_of(12);
    std::vector<Order> possible;
    for (std::uint64_t answer = 0; answer < 4; ++answer) {
        Order order{candidates_of(offer), kFlight};
        const genome::Offer skies = offer_of(100 + answer);
        for (std::size_t i = 0; i < order.candidates.size(); ++i) {
            for (const auto id : genome::parameters_of(Aspect::Sky, genome::Genome::Full))
                order.candidates[i].values.set(id, skies.candidates[i].values[id]);
            order.candidates[i].seeds[Aspect::Sky] = skies.candidates[i].seeds[Aspect::Sky];
        }
        possible.push_back(std::move(order));
    }
    Grower grower({2, kFine});
    grower.begin([&] { return HeadStart{possible.front(), {Aspect::Trees, Aspect::Land}, possible}; });
    while (grower.ahead().lit.size() < 16) std::this_thread::yield();
    const Scenes all = grower.ahead().lit;
    grower.order(possible[2]);
    ASSERT_TRUE(grower.is_ready());
    const Scenes first = *grower.take();
    EXPECT_TRUE(grower.ahead().lit.empty());
    grower.refine();
    const Scenes refined = taken([&] { return grower.take_refined(); });
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NE(std::ranges::find(all, first[i]), all.end());
        EXPECT_EQ(first[i]->sky, refined[i]->sky);
        const auto at_once = grow(genome::recipe_of(possible[2].candidates[i], kFlight), kFine);
        EXPECT_EQ(refined[i]->sky->dome, at_once->sky->dome);
        EXPECT_EQ(refined[i]->light.ground, at_once->light.ground);
    }
}

TEST(Ahead, AnAnswerTakenBackForgetsWhatWasLitForIt) {
    const genome::Offer offer = offer_of(13);
    const Order order{candidates_of(offer), kFlight};
    Grower grower({2, kFine});
    grower.begin([&] { return HeadStart{order, {Aspect::Trees, Aspect::Land}, {order}}; });
    while (grower.ahead().lit.size() < 4) std::this_thread::yield();
    grower.begin([&] { return HeadStart{order, {Aspect::Trees}, {}}; });
    while (grower.stock().is_busy) std::this_thread::yield();
    EXPECT_TRUE(grower.ahead().lit.empty());
    grower.order(order);
    EXPECT_FALSE(grower.is_ready());
    grower.wait();
    EXPECT_TRUE(grower.is_ready());
}

}  // namespace
}  // namespace quadrat::nursery
