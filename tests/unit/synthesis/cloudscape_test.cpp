// SPDX-License-Identifier: Apache-2.0
#include "synthesis/sky/cloudscape.hpp"
#include "scene/sky_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/grow.hpp"

namespace quadrat::synthesis::sky {
namespace {

constexpr int kWidth = 256;
constexpr int kHeight = 96;

glm::vec3 direction_of(int x, int y) {
    return scene::cloudscape_direction(
        {(static_cast<float>(x) + 0.5F) / kWidth, (static_cast<float>(y) + 0.5F) / kHeight});
}

float opacity(const scene::Cloudscape& clouds, int x, int y) { return static_cast<float>(clouds.pixel(x, y)[0]) / 255; }

// Beer and Lambert: a sheet of one thickness hides as the way through it grows, by 1 / sine of the ray's height over
// it.
TEST(Cloudscape, HidesBehindAnEvenSheetWhatTheWayThroughItAsksFor) {
    const mesh::Field depth(64, 64, 0.12F);
    CloudscapeShape shape{depth};
    shape.swelling = 0;
    const scene::Cloudscape clouds = make_cloudscape(shape, kWidth, kHeight);
    const auto thickness = [&](int y) { return -std::log(1 - opacity(clouds, 128, y)); };
    const auto way = [&](int y) {
        const glm::vec3 d = direction_of(128, y);
        const float t = (d.y + scene::kBendsDown) / std::hypot(d.x, d.z);
        return std::sqrt(1 + t * t) / t;
    };
    const float each = thickness(60) / way(60);
    ASSERT_GT(thickness(60), 0.02F);
    for (const int y : {24, 34, 44, 54, 70}) EXPECT_NEAR(thickness(y) / way(y), each, 0.12F * each) << y;
}

TEST(Cloudscape, IsAlikeAllAroundUnderAnEvenSheet) {
    const mesh::Field depth(64, 64, 0.6F);
    CloudscapeShape shape{depth};
    shape.swelling = 0;
    const scene::Cloudscape clouds = make_cloudscape(shape, kWidth, kHeight);
    for (const int y : {10, 40, 80})
        for (int x = 1; x < kWidth; ++x) ASSERT_NEAR(clouds.pixel(x, y)[0], clouds.pixel(0, y)[0], 1) << x << " " << y;
}

// A gap of 1 reaches a sine of 0.24, ragged by less than a third.
TEST(Cloudscape, LeavesItsGapOpenAndClosesOverIt) {
    const mesh::Field depth(64, 64, 4.0F);
    CloudscapeShape shape{depth};
    shape.tall_m = 60;
    shape.gap = 1;
    const scene::Cloudscape clouds = make_cloudscape(shape, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; x += 7) {
            const float height = direction_of(x, y).y;
            if (height < 0.10F) {
                EXPECT_LT(opacity(clouds, x, y), 0.02F) << x << " " << y;
            }
            if (height > 0.45F) {
                EXPECT_GT(opacity(clouds, x, y), 0.95F) << x << " " << y;
            }
        }
    }
    EXPECT_LT(closed_over_gap(1, 0.05F), 0.01F);
    EXPECT_EQ(closed_over_gap(1, 0.4F), 1);
    EXPECT_EQ(closed_over_gap(0, 0.01F), 1);
}

// One heap north of the eye.
TEST(Cloudscape, LightsTheSideTowardTheLight) {
    mesh::Field depth(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            // Half a tile north of the eye.
            const float off = std::hypot(static_cast<float>(std::min(x, 128 - x)), static_cast<float>(y) - 64) / 12;
            depth.at(x, y) = std::max(4.0F * (1 - off * off), 0.0F);
        }
    const auto sides = [&](glm::vec3 light) {
        CloudscapeShape shape{depth};
        shape.tile_m = 9000;
        shape.base_m = 700;
        shape.tall_m = 900;
        shape.light = glm::normalize(light);
        const scene::Cloudscape clouds = make_cloudscape(shape, 512, 160);
        glm::dvec2 west_east{0};
        for (int y = 0; y < 160; ++y) {
            for (int x = 0; x < 512; ++x) {
                const glm::vec3 d = scene::cloudscape_direction(
                    {(static_cast<float>(x) + 0.5F) / 512, (static_cast<float>(y) + 0.5F) / 160});
                const double o = clouds.pixel(x, y)[0];
                if (d.z > -0.9F || o < 200) continue;
                const double lit = clouds.pixel(x, y)[1] / o;
                if (d.x < -0.04F) west_east.x += lit;
                if (d.x > 0.04F) west_east.y += lit;
            }
        }
        return west_east.y / west_east.x;
    };
    EXPECT_GT(sides({1, 0.5F, 0.3F}), 1.1 * sides({-1, 0.5F, 0.3F}));
}

TEST(Cloudscape, HasBeamsOnlyWhereCloudsLetLightThroughAndARingWhereIceWould) {
    const mesh::Field none(64, 64, 0.0F);
    CloudscapeShape shape{none};
    shape.disc = glm::normalize(glm::vec3{0, 0.5F, -1});
    shape.beams = 1;
    for (const std::uint8_t byte : make_cloudscape(shape, kWidth, kHeight).bytes) ASSERT_EQ(byte, 0);
    shape.halo = 1;
    const scene::Cloudscape ring = make_cloudscape(shape, 720, 240);
    float brightest = 0;
    float at_deg = 0;
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 720; ++x) {
            const glm::vec3 d = scene::cloudscape_direction(
                {(static_cast<float>(x) + 0.5F) / 720, (static_cast<float>(y) + 0.5F) / 240});
            if (ring.pixel(x, y)[1] <= brightest) continue;
            brightest = ring.pixel(x, y)[1];
            at_deg = std::acos(glm::dot(d, shape.disc)) * 57.29578F;
        }
    }
    EXPECT_NEAR(at_deg, 22, 0.7F);
}

TEST(Cloudscape, OfASkyIsTheSameForTheSameSeed) {
    scene::SkyParameters p;
    EXPECT_EQ(grow_sky(p, base::Seed{4}).cloudscape, grow_sky(p, base::Seed{4}).cloudscape);
    EXPECT_NE(grow_sky(p, base::Seed{4}).cloudscape, grow_sky(p, base::Seed{5}).cloudscape);
}

}  // namespace
}  // namespace quadrat::synthesis::sky
