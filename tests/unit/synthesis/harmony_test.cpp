// SPDX-License-Identifier: Apache-2.0
// Colours that a scene can hold at once, in OKLab: what the genes may do to a palette leaves it one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "genome/recipe.hpp"
#include "scene/colour.hpp"
#include "scene/parameters.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/trees/form.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

struct Tone {
    float lightness, chroma, hue_deg;  // hue 0 to 360: 30 red, 90 yellow, 140 green, 260 blue
};

Tone tone_of(const glm::vec3& linear) {
    const glm::vec3 lab = scene::oklab_from_linear(linear);
    const float turn = std::atan2(lab.z, lab.y) * 180 / std::numbers::pi_v<float>;
    return {lab.x, std::hypot(lab.y, lab.z), turn < 0 ? turn + 360 : turn};
}

// The widest arc of hues that holds all but `accents` of those that are coloured at all (the templates of Cohen-Or et
// al., "Color harmonization", 2006, are such arcs with an accent opposite).
float arc_deg(const std::vector<glm::vec3>& colours, std::size_t accents) {
    std::vector<float> hues;
    for (const glm::vec3& colour : colours)
        if (const Tone tone = tone_of(colour); tone.chroma > 0.03F) hues.push_back(tone.hue_deg);
    if (hues.size() <= accents + 1) return 0;
    std::ranges::sort(hues);
    const std::size_t within = hues.size() - accents;
    float least = 360;
    for (std::size_t i = 0; i < hues.size(); ++i) {
        const float end = hues[(i + within - 1) % hues.size()];
        least = std::min(least, end >= hues[i] ? end - hues[i] : end - hues[i] + 360);
    }
    return least;
}

scene::SceneParameters anything(std::uint64_t seed) {
    return scene::realise(genome::random_recipe(base::Seed{seed}).values);
}

TEST(Harmony, EveryCountryAndWhatLiesBetweenTwoIsOneArcOfHuesWithAtMostOneAccent) {
    for (int step = 0; step <= 50; ++step) {
        scene::LandParameters p;
        p.ground_chance = 0;
        p.ground_country = 0.1F * static_cast<float>(step);
        const land::Palette c = land::choose_palette(p, base::Seed{1});
        EXPECT_LE(arc_deg({c.lush, c.dry, c.heath, c.soil, c.scree, c.rock_light, c.rock_dark, c.sand}, 1), 90)
            << p.ground_country;
        EXPECT_GE(tone_of(c.sand).lightness - tone_of(c.rock_dark).lightness, 0.22F) << p.ground_country;
        EXPECT_LE(tone_of(c.deep).lightness, 0.45F) << p.ground_country;
    }
}

TEST(Harmony, NoGeneMakesGroundGarishOrSnowColoured) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const scene::SceneParameters p = anything(seed);
        const land::Palette c = land::choose_palette(p.land, base::Seed{seed});
        for (const glm::vec3& colour : {c.lush, c.dry, c.heath, c.soil, c.scree, c.rock_light, c.rock_dark, c.sand}) {
            EXPECT_LE(tone_of(colour).chroma, 0.125F) << seed;
            EXPECT_GE(tone_of(colour).lightness, 0.35F) << seed;
        }
        EXPECT_LE(tone_of(c.snow).chroma, 0.02F) << seed;
    }
}

TEST(Harmony, NoGeneMakesBlueLeavesOrVioletBark) {
    constexpr std::array kRanks{trees::Rank::First, trees::Rank::Second, trees::Rank::Third};
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const scene::SceneParameters p = anything(seed);
        for (const trees::Rank rank : kRanks) {
            const trees::Form form = trees::form_of(p.trees, rank);
            for (const glm::vec3& leaf : {form.colours.leaf, form.colours.second}) {
                const Tone tone = tone_of(leaf);
                EXPECT_LE(tone.chroma, 0.2F) << seed;
                EXPECT_LE(scene::luminance(leaf), 0.37F) << seed << ": it would take the colour of the light";
                // Pink is blossom among them.
                EXPECT_TRUE(tone.chroma < 0.05F || tone.hue_deg < 215 || tone.hue_deg > 340)
                    << seed << ": hue " << tone.hue_deg;
            }
            const Tone bark = tone_of(form.bark);
            EXPECT_TRUE(bark.chroma < 0.03F || bark.hue_deg < 160) << seed << ": hue " << bark.hue_deg;
        }
        const trees::Wear wear = trees::wear_of(p.trees);
        EXPECT_LE(arc_deg({wear.grass, scene::linear_from_srgb_hex(0x5E7F3A)}, 0), 60)
            << seed << ": grass is green to straw";
    }
}

}  // namespace
