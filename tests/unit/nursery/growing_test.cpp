// SPDX-License-Identifier: Apache-2.0
#include "nursery/growing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <tuple>

namespace quadrat::nursery {
namespace {

const scene::Fineness kCoarse{65, 64, 128};

std::vector<genome::Candidate> candidates(std::uint64_t seed) {
    std::vector<genome::Candidate> all;
    for (std::size_t i = 0; i < genome::kCandidates; ++i)
        all.push_back(genome::candidate_of(genome::random_recipe(base::Seed{seed}.child(i))));
    return all;
}

std::vector<Want> awaited(const Landscapes& landscapes) {
    return wants_for(landscapes, Stage::FirstLight, Urgency::Awaited);
}

Scenes grown_by(int threads, std::uint64_t seed) {
    Nursery nursery({threads, kCoarse});
    const Landscapes four = landscapes_of(candidates(seed), base::Seed{seed});
    nursery.want(awaited(four));
    nursery.wait();
    return nursery.find(four)->scenes;
}

bool are_same(const scene::Scene& a, const scene::Scene& b) {
    const auto plants = [](const scene::Scene& s) {
        std::vector<std::tuple<std::uint32_t, float, float, float, float>> all;
        for (const auto& p : s.plants) all.emplace_back(p.species, p.root_m.x, p.root_m.z, p.yaw_rad, p.scale);
        return all;
    };
    return a.land->height_m == b.land->height_m && a.land->albedo == b.land->albedo &&
           a.light.ground == b.light.ground && a.sky->dome == b.sky->dome && plants(a) == plants(b) &&
           a.flora->species.front().wood.front().mesh == b.flora->species.front().wood.front().mesh;
}

TEST(Threads, AGenerationIsTheSameOnAnyNumberOfThreads) {
    const Scenes one = grown_by(1, 5);
    const Scenes four = grown_by(4, 5);
    ASSERT_EQ(one.size(), 4U);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_TRUE(are_same(*one[i], *four[i])) << i;
    EXPECT_FALSE(are_same(*one[0], *one[1]));
}

TEST(Threads, GrowingInTheBackgroundEqualsGrowingAtOnce) {
    const auto all = candidates(9);
    const Scenes background = grown_by(2, 9);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_TRUE(are_same(*background[i], *grow(genome::recipe_of(all[i], base::Seed{9}), kCoarse)));
}

TEST(Threads, WhatIsAwaitedReplacesWhatWasAndWhatWasForeseenIsShared) {
    Nursery nursery({2, kCoarse});
    const Landscapes first = landscapes_of(candidates(1), base::Seed{1});
    nursery.foresee([&] {
        auto wants = wants_for(first, Stage::Aspects, Urgency::Coming);
        for (Want& want : wants) want.known = {{true, false, false}};
        return wants;
    });
    while (nursery.stock().kept < first.size()) std::this_thread::yield();
    const Landscapes others = landscapes_of(candidates(2), base::Seed{2});
    nursery.want(awaited(others));
    nursery.want(awaited(first));
    nursery.wait();
    EXPECT_EQ(nursery.progress(), 1.0F);
    EXPECT_FALSE(nursery.find(others)) << "nobody wants them any more";
    const auto lit = nursery.find(first);
    ASSERT_TRUE(lit);
    EXPECT_TRUE(
        are_same(*lit->scenes.front(), *grow(genome::recipe_of(first.front()->candidate, base::Seed{1}), kCoarse)));
    nursery.want({});
    EXPECT_FALSE(nursery.find(first));
    // The same four again share what they are made of.
    const Landscapes again = landscapes_of(candidates(1), base::Seed{77});
    nursery.want(awaited(again));
    nursery.wait();
    EXPECT_EQ(nursery.find(again)->scenes.front()->land.get(), lit->scenes.front()->land.get());
}

TEST(Threads, WhatIsGrownAndNeverComposedDoesNotPileUp) {
    Nursery nursery({2, kCoarse});
    std::size_t most = 0;
    for (std::uint64_t i = 0; i < 12; ++i) {
        nursery.foresee([i] {
            auto wants = wants_for(landscapes_of(candidates(i), base::Seed{i}), Stage::Aspects, Urgency::Coming);
            for (Want& want : wants) want.known = {{false, false, true}};
            return wants;
        });
        while (nursery.stock().is_busy) std::this_thread::yield();
        most = std::max(most, nursery.stock().kept);
    }
    EXPECT_LE(most, Graph::kAspectsKept);
    EXPECT_GE(most, genome::kCandidates * genome::kAspects.size());
    // What was forgotten grows again.
    const Landscapes first = landscapes_of(candidates(0), base::Seed{3});
    nursery.want(awaited(first));
    nursery.wait();
    EXPECT_TRUE(are_same(*nursery.find(first)->scenes.front(),
                         *grow(genome::recipe_of(first.front()->candidate, base::Seed{3}), kCoarse)));
}

TEST(Threads, ANurseryThatIsNotWaitedForEndsQuietly) {
    for (std::uint64_t i = 0; i < 3; ++i) {
        Nursery nursery({2, kCoarse});
        nursery.want(awaited(landscapes_of(candidates(i), base::Seed{i})));
        EXPECT_LE(nursery.progress(), 1.0F);
    }
}

}  // namespace
}  // namespace quadrat::nursery
