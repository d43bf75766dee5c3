// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/questions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/seed.hpp"

namespace quadrat::breeding {
namespace {

TEST(Questions, BeginAsHaltonsSequenceDoes) {
    const std::array<std::array<double, 3>, 4> first{
        {{0.5, 1.0 / 3, 0.2}, {0.25, 2.0 / 3, 0.4}, {0.75, 1.0 / 9, 0.6}, {0.125, 4.0 / 9, 0.8}}};
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(halton(i, 3)[d], first[i][d], 1e-12) << i << ' ' << d;
}

// How far from even: of boxes at the origin, the greatest difference between their volume and the share of the points.
double discrepancy(const std::vector<Point>& points) {
    double most = 0;
    for (int x = 1; x <= 20; ++x)
        for (int y = 1; y <= 20; ++y) {
            const auto in =
                std::ranges::count_if(points, [&](const Point& p) { return 20 * p[0] < x && 20 * p[1] < y; });
            most =
                std::max(most, std::abs(static_cast<double>(in) / static_cast<double>(points.size()) - x * y / 400.0));
        }
    return most;
}

TEST(Questions, CoverTheWordsTwiceAsEvenlyAsChance) {
    std::vector<Point> asked;
    std::vector<Point> chance;
    base::RandomStream random{base::Seed{3}};
    for (std::size_t i = 0; i < 64; ++i) {
        asked.push_back(halton(i, 7));
        chance.push_back({random.unit(), random.unit()});
    }
    EXPECT_LT(discrepancy(asked), 0.5 * discrepancy(chance));
}

TEST(Questions, AreScenesThatTheMapCanBeTrainedWithOnceTheyAreDescribed) {
    const WordMap& map = default_word_map();
    auto scenes = scenes_to_describe(map, genome::Aspect::Sky, 4, 3);
    ASSERT_EQ(scenes.size(), 3U);
    EXPECT_EQ(scenes[0].name, "question 5");
    EXPECT_NE(scenes[0].values, scenes[1].values);
    for (const auto& word : scenes[0].words) EXPECT_FALSE(word.has_value());
    EXPECT_EQ(described_scenes_from(to_json(scenes, genome::Aspect::Sky), "asked.json"), scenes);
}

TEST(Questions, AreWholeLandscapesWhoseWordsAreTheSequence) {
    const WordMap& map = default_word_map();
    const genome::Candidate first = landscape_to_describe(map, 0, base::Seed{1});
    ASSERT_TRUE(first.words);
    const auto trees = genome::vocabulary(genome::Aspect::Trees);
    EXPECT_FLOAT_EQ((*first.words)[trees[0].id], 0);          // a half
    EXPECT_FLOAT_EQ((*first.words)[trees[1].id], -1.0F / 3);  // a third
    EXPECT_EQ(first, landscape_to_describe(map, 0, base::Seed{1}));
    EXPECT_NE(first.values, landscape_to_describe(map, 1, base::Seed{1}).values);
    // Its values are the map's, of every aspect.
    for (const genome::Aspect aspect : genome::kAspects) {
        genome::ParameterValues values = first.values;
        map.realise(aspect, *first.words, values);
        EXPECT_EQ(values, first.values);
        for (const genome::Word& word : genome::vocabulary(aspect)) EXPECT_LT(std::abs((*first.words)[word.id]), 1);
    }
}

}  // namespace
}  // namespace quadrat::breeding
