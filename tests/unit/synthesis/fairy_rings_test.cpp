// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/fairy_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/tree_parameters.hpp"
#include "synthesis/trees/flora.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

constexpr int kSide = 96;

struct Ring {
    float radius = 0, spread = 0, most = 0, inside = 0;
};

// About the middle of what one beginning grew to.
Ring ring_of(int steps) {
    const mesh::Field field = noise::fairy_rings({.beginnings = 1, .steps = steps}, base::Seed{4}, kSide);
    const auto most = std::ranges::max_element(field.samples);
    // The torus is turned so that the ring does not cross its edge: from each sample to the mean direction.
    float cx = 0, sx = 0, cy = 0, sy = 0;
    const float turn = 6.2831853F / kSide;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float w = field.at(x, y);
            cx += w * std::cos(turn * static_cast<float>(x));
            sx += w * std::sin(turn * static_cast<float>(x));
            cy += w * std::cos(turn * static_cast<float>(y));
            sy += w * std::sin(turn * static_cast<float>(y));
        }
    const float mx = std::atan2(sx, cx) / turn, my = std::atan2(sy, cy) / turn;
    const auto off = [](float d) {
        d = std::fmod(std::abs(d), static_cast<float>(kSide));
        return std::min(d, kSide - d);
    };
    Ring ring;
    ring.most = *most;
    float weights = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float r = std::hypot(off(static_cast<float>(x) - mx), off(static_cast<float>(y) - my));
            const float w = field.at(x, y);
            if (r < 2) ring.inside = std::max(ring.inside, w);
            if (w < 0.5F * *most) continue;
            weights += w;
            ring.radius += w * r;
            ring.spread += w * r * r;
        }
    ring.radius /= weights;
    ring.spread = std::sqrt(std::max(ring.spread / weights - ring.radius * ring.radius, 0.0F));
    return ring;
}

TEST(FairyRings, GrowOutwardAtTheSpeedOfTheirFrontAndLeaveTheirMiddleSpent) {
    const Ring early = ring_of(40), late = ring_of(60);
    for (const Ring& ring : {early, late}) {
        EXPECT_LT(ring.inside, 0.15F * ring.most);
        EXPECT_LT(ring.spread, 0.2F * ring.radius) << "and round";
    }
    // A front is as fast as the slowest of the waves exp(-l x) that lead it (Kolmogorov et al. 1937), here in steps of
    // 0.7 on samples: each step multiplies such a wave by 1 + 0.7 (0.22 (2 cosh l - 2) + 1 - 0.3).
    float slowest = 9;
    for (float l = 0.5F; l < 3; l += 0.01F)
        slowest = std::min(slowest, std::log(1 + 0.7F * (0.22F * (2 * std::cosh(l) - 2) + 0.7F)) / (0.7F * l));
    const float speed = (late.radius - early.radius) / (20 * 0.7F);
    EXPECT_NEAR(speed, slowest, 0.05F);
}

TEST(FairyRings, GoOutWhereTwoMeet) {
    // Long enough for the whole torus to be eaten.
    const mesh::Field field = noise::fairy_rings({.beginnings = 6, .steps = 400}, base::Seed{4}, 48);
    EXPECT_LT(*std::ranges::max_element(field.samples), 0.02F);
}

TEST(FairyRings, BearMushroomsWhereTheGeneAsksForThem) {
    const auto has = [](float rings) {
        scene::TreeParameters p;
        p.mushroom_rings = rings;
        return std::ranges::any_of(trees::make_flora(p, base::Seed{2}).species,
                                   [](const scene::Species& s) { return s.name == "mushroom"; });
    };
    EXPECT_FALSE(has(0.4F));
    EXPECT_TRUE(has(0.8F));
}

}  // namespace
