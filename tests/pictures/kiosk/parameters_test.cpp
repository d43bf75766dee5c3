// SPDX-License-Identifier: Apache-2.0
// Every parameter of the classic genome shows: the pictures at the two ends of its range differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "kiosk/easel.hpp"

namespace quadrat::kiosk {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 135;

mesh::Image picture_with(Easel& easel, const genome::Parameter& parameter, float value) {
    Picture picture;
    picture.width = kWidth;
    picture.height = kHeight;
    genome::Recipe recipe = genome::random_recipe(base::Seed{12});
    recipe.values = genome::ParameterValues{};
    recipe.values.set(parameter.id, value);
    picture.scenes = {recipe};
    return easel.draw(picture, {grow(recipe, {129, 128, 256})});
}

// The mean over the 5 % of pixels that differ most, of their largest channel difference in code values.
double visible_difference(const mesh::Image& a, const mesh::Image& b) {
    std::vector<int> differences;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
            differences.push_back(most);
        }
    }
    std::ranges::sort(differences, std::greater<>{});
    const std::size_t few = differences.size() / 20;
    double sum = 0;
    for (std::size_t i = 0; i < few; ++i) sum += differences[i];
    return sum / static_cast<double>(few);
}

TEST(Parameters, EveryClassicOneIsVisibleFromEndToEnd) {
    Easel easel(kWidth, kHeight);
    int seen = 0;
    for (const genome::Parameter& parameter : genome::parameter_table()) {
        if (parameter.genome != genome::Genome::Classic) continue;
        const mesh::Image low = picture_with(easel, parameter, parameter.min);
        const mesh::Image high = picture_with(easel, parameter, parameter.max);
        EXPECT_GT(visible_difference(low, high), 12) << parameter.name;
        ++seen;
    }
    EXPECT_EQ(seen, 21);
}

}  // namespace
}  // namespace quadrat::kiosk
