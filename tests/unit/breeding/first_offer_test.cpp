// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "breeding/belief/companions.hpp"
#include "breeding/belief/four_means.hpp"
#include "breeding/session.hpp"
#include "breeding/words/described_scene.hpp"
#include "genome/parameter_ids.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;

genome::Offer first_offer(std::uint64_t seed) {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    return Session(Breeder(options), base::Seed{seed}).offer();
}

// On a line the farther half of what is left after the first is known.
TEST(DrawnApart, TakesTheOthersFromTheFartherHalf) {
    std::vector<Place> places;
    for (int i = 0; i < 16; ++i) places.push_back({i / 15.0});
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        base::RandomStream chance(base::Seed{seed});
        const auto drawn = drawn_apart(places, 4, chance);
        ASSERT_EQ(std::set<std::size_t>(drawn.begin(), drawn.end()).size(), 4U);
        std::vector<double> apart;
        for (std::size_t i = 0; i < places.size(); ++i)
            if (i != drawn[0]) apart.push_back(squared_distance(places[i], places[drawn[0]]));
        std::ranges::sort(apart, std::greater{});
        EXPECT_GE(squared_distance(places[drawn[1]], places[drawn[0]]), apart[apart.size() / 2 - 1]);
    }
}

TEST(DrawnApart, EveryPlaceHasItsTurn) {
    std::vector<Place> places;
    for (int i = 0; i < 20; ++i) places.push_back({i / 19.0, (i * 7 % 20) / 19.0});
    std::vector<int> times(places.size(), 0);
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        base::RandomStream chance(base::Seed{seed});
        for (const std::size_t i : drawn_apart(places, 4, chance)) ++times[i];
    }
    // A fifth each would be equal shares.
    EXPECT_THAT(times, testing::Each(testing::AllOf(testing::Gt(60), testing::Lt(450))));
}

TEST(FirstOffer, GoesTogether) {
    double sum = 0;
    int below = 0;
    constexpr int kOffers = 60;
    for (std::uint64_t seed = 0; seed < kOffers; ++seed) {
        double of_four = 0;
        for (const genome::Candidate& c : first_offer(seed).candidates) of_four += accord(*c.words);
        sum += of_four / 4;
        below += of_four < 0 ? 1 : 0;
    }
    // By chance it is 0 in the mean, and every second is below it.
    EXPECT_GT(sum / kOffers, 0.25);
    EXPECT_LE(below, 3);
}

TEST(FirstOffer, SnowFallsOnTheColdestLand) {
    int snowing = 0;
    int coldest = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const genome::Offer offer = first_offer(seed);
        const genome::Candidate* snowy = nullptr;
        int skies = 0;
        float cold = -2;
        for (const genome::Candidate& c : offer.candidates) {
            cold = std::max(cold, (*c.words)[genome::WordId::cold]);
            if (c.values[genome::ParameterId::snowfall_share] <= 0) continue;
            snowy = &c;
            ++skies;
        }
        if (skies != 1) continue;
        ++snowing;
        coldest += (*snowy->words)[genome::WordId::cold] >= cold - 0.1F ? 1 : 0;
    }
    ASSERT_GT(snowing, 5);
    EXPECT_GE(coldest, (9 * snowing + 9) / 10);
}

TEST(FirstOffer, PuttingTogetherTwiceChangesNothing) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const genome::Offer offer = first_offer(seed);
        genome::Offer again = offer;
        put_together(again);
        EXPECT_EQ(again, offer);
    }
}

// What is offered of an aspect stays the same four, in another order.
TEST(FirstOffer, PuttingTogetherKeepsWhatIsOfferedOfEachAspect) {
    genome::Offer offer = first_offer(7);
    genome::Offer shuffled = offer;
    std::swap(shuffled.candidates[0], shuffled.candidates[3]);
    for (const genome::Word& word : genome::vocabulary(Aspect::Land)) {
        const float a = (*shuffled.candidates[1].words)[word.id];
        shuffled.candidates[1].words->set(word.id, (*shuffled.candidates[2].words)[word.id]);
        shuffled.candidates[2].words->set(word.id, a);
    }
    const auto four = [](const genome::Offer& of, genome::WordId word) {
        std::multiset<float> values;
        for (const genome::Candidate& c : of.candidates) values.insert((*c.words)[word]);
        return values;
    };
    genome::Offer matched = shuffled;
    put_together(matched);
    for (const genome::Word& word : genome::vocabulary()) EXPECT_EQ(four(matched, word.id), four(shuffled, word.id));
}

TEST(FirstOffer, ShowsNearlyAllThatIsNamed) {
    std::set<std::vector<float>> seen;
    for (std::uint64_t seed = 0; seed < 150; ++seed)
        for (const genome::Candidate& c : first_offer(seed).candidates) {
            std::vector<float> words;
            for (const genome::Word& word : genome::vocabulary(Aspect::Land)) words.push_back((*c.words)[word.id]);
            seen.insert(words);
        }
    EXPECT_GT(seen.size(), 0.9 * static_cast<double>(archetypes(Aspect::Land).size()));
}

}  // namespace
}  // namespace quadrat::breeding
