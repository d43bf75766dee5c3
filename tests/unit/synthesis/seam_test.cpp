// SPDX-License-Identifier: Apache-2.0
// Where the land ends, the country around it goes on in the same colours: there was a dark slab behind it once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "genome/recipe.hpp"
#include "scene/colour.hpp"
#include "scene/parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/land/country.hpp"

namespace {

using namespace quadrat;

constexpr float kPatch_m = 32;

float luma_at(const scene::Land& land, glm::vec2 at_m) {
    const auto px = [&](float m) {
        const float share = m / land.side_m() + 0.5F;
        return std::clamp(static_cast<int>(share * static_cast<float>(land.albedo.width())), 0,
                          land.albedo.width() - 1);
    };
    const glm::u8vec3 c = land.albedo.colour(px(at_m.x), px(at_m.y));
    return (0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b) / 255;
}

// The mean of a patch of the land about a place.
float land_luma(const scene::Land& land, glm::vec2 at_m) {
    constexpr int kSteps = 4;
    float sum = 0;
    for (int y = 0; y < kSteps; ++y)
        for (int x = 0; x < kSteps; ++x)
            sum += luma_at(land,
                           at_m + kPatch_m *
                                      (glm::vec2{static_cast<float>(x), static_cast<float>(y)} + 0.5F - 0.5F * kSteps) /
                                      static_cast<float>(kSteps));
    return sum / (kSteps * kSteps);
}

float surround_luma(const scene::Land& land, glm::vec2 at_m) {
    const mesh::Image& image = land.surround_albedo;
    const float half = 0.5F * static_cast<float>(image.width - 1);
    const glm::vec2 at = at_m / land.surround_cell_m + half;
    const auto luma = [&](int x, int y) {
        const std::uint8_t* p = image.pixel(x, y);
        return (0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2]) / 255;
    };
    const int x = static_cast<int>(at.x);
    const int y = static_cast<int>(at.y);
    const glm::vec2 t = at - glm::floor(at);
    return (1 - t.y) * ((1 - t.x) * luma(x, y) + t.x * luma(x + 1, y)) +
           t.y * ((1 - t.x) * luma(x, y + 1) + t.x * luma(x + 1, y + 1));
}

struct Seam {
    double worst = 0;   // how much a step over it is stronger than the strongest between patches beside it
    double mean = 0;    // strength of a step over it
    double inside = 0;  // and of one beside it
};

Seam seam_of(const scene::Land& land) {
    const float edge_m = 0.5F * land.side_m();
    Seam seam;
    int count = 0;
    for (int side = 0; side < 4; ++side) {
        const glm::vec2 out{side == 0 ? 1 : side == 1 ? -1 : 0, side == 2 ? 1 : side == 3 ? -1 : 0};
        const glm::vec2 along{-out.y, out.x};
        for (float a = -416; a <= 416; a += 64) {
            const auto inside = [&](float in_m, float aside_m) {
                return land_luma(land, (edge_m - in_m) * out + (a + aside_m) * along);
            };
            const float last = inside(16, 0);
            const float over = std::abs(surround_luma(land, (edge_m + 16) * out + a * along) - last);
            // Whichever way they go: where snow ends at the seam, it ends beside it, too.
            float beside = 0;
            for (const float aside_m : {-64.0F, -32.0F, 0.0F, 32.0F})
                for (const float in_m : {16.0F, 48.0F, 80.0F}) {
                    beside = std::max(beside, std::abs(inside(in_m, aside_m) - inside(in_m + 32, aside_m)));
                    beside = std::max(beside, std::abs(inside(in_m, aside_m) - inside(in_m, aside_m + 32)));
                }
            seam.worst = std::max(seam.worst, static_cast<double>(over - beside));
            seam.mean += over;
            seam.inside += std::abs(inside(16, 0) - inside(48, 0));
            ++count;
        }
    }
    seam.mean /= count;
    seam.inside /= count;
    return seam;
}

TEST(Seam, IsNoStrongerAnEdgeThanTheGroundBesideIt) {
    double over = 0;
    double beside = 0;
    for (std::uint64_t seed = 0; seed < tests::of(40U); ++seed) {
        const scene::SceneParameters p = scene::realise(genome::random_recipe(base::Seed{seed}).values);
        const Seam seam = seam_of(synthesis::land::make_land(p.land, base::Seed{seed}, {65, 64, 128}));
        EXPECT_LT(seam.worst, 0.05) << seed;  // of the whole scale, at one place
        over += seam.mean;
        beside += seam.inside;
    }
    EXPECT_LT(over, 1.25 * beside) << "in the mean";
}

}  // namespace
