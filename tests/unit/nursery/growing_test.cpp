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

Scenes grown_by(int threads, std::uint64_t seed) {
    Grower grower({threads, kCoarse});
    grower.order({candidates(seed), base::Seed{seed}});
    grower.wait();
    return *grower.take();
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

TEST(Threads, AnOrderReplacesTheOneBeforeAndHeadStartsAreShared) {
    Grower grower({2, kCoarse});
    const auto first = candidates(1);
    grower.begin([&] { return HeadStart{{first, base::Seed{1}}, {genome::Aspect::Trees}, {}}; });
    while (grower.stock().kept < first.size()) std::this_thread::yield();
    grower.order({candidates(2), base::Seed{2}});
    grower.order({first, base::Seed{1}});
    grower.wait();
    EXPECT_TRUE(grower.is_ready());
    EXPECT_EQ(grower.progress(), 1.0F);
    const auto scenes = grower.take();
    ASSERT_TRUE(scenes.has_value());
    EXPECT_TRUE(are_same(*scenes->front(), *grow(genome::recipe_of(first.front(), base::Seed{1}), kCoarse)));
    EXPECT_FALSE(grower.take().has_value());
    // The same four again share what they are made of.
    grower.order({first, base::Seed{77}});
    grower.wait();
    EXPECT_EQ(grower.take()->front()->land.get(), scenes->front()->land.get());
}

TEST(Threads, WhatIsGrownAndNeverComposedDoesNotPileUp) {
    Grower grower({2, kCoarse});
    std::size_t most = 0;
    for (std::uint64_t i = 0; i < 12; ++i) {
        grower.begin([&] { return HeadStart{{candidates(i), base::Seed{i}}, {genome::Aspect::Sky}, {}}; });
        while (grower.stock().is_busy) std::this_thread::yield();
        most = std::max(most, grower.stock().kept);
    }
    EXPECT_LE(most, 2 * genome::kCandidates * genome::kAspects.size());
    EXPECT_GE(most, genome::kCandidates * genome::kAspects.size());
    // What was forgotten grows again.
    const auto first = candidates(0);
    grower.order({first, base::Seed{3}});
    grower.wait();
    EXPECT_TRUE(are_same(*grower.take()->front(), *grow(genome::recipe_of(first.front(), base::Seed{3}), kCoarse)));
}

TEST(Threads, AGrowerThatIsNotWaitedForEndsQuietly) {
    for (std::uint64_t i = 0; i < 3; ++i) {
        Grower grower({2, kCoarse});
        grower.order({candidates(i), base::Seed{i}});
        EXPECT_LE(grower.progress(), 1.0F);
    }
}

}  // namespace
}  // namespace quadrat::nursery
