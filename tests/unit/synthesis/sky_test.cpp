// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "genome/recipe.hpp"
#include "scene/sky_parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/light.hpp"
#include "synthesis/compose/openness.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/sky/atmosphere.hpp"
#include "synthesis/sky/clouds.hpp"
#include "synthesis/sky/night.hpp"
#include "synthesis/sky/preetham.hpp"

namespace quadrat::synthesis::sky {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 toward(float bearing_deg, float height_deg) {
    const float a = glm::radians(bearing_deg);
    const float h = glm::radians(height_deg);
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
}

float luminance(const glm::vec3& c) { return glm::dot(c, glm::vec3{0.2126F, 0.7152F, 0.0722F}); }

// Irradiance on level ground of what a function of direction sends, by a fine midpoint rule.
template <typename Radiance>
glm::vec3 level_irradiance(const Radiance& radiance) {
    constexpr int kHeights = 96;
    constexpr int kBearings = 96;
    glm::dvec3 sum{0};
    for (int i = 0; i < kHeights; ++i) {
        const float y = std::sqrt((static_cast<float>(i) + 0.5F) / kHeights);  // equal pieces of the projected disc
        for (int k = 0; k < kBearings; ++k) {
            const float turn = 2 * kPi * (static_cast<float>(k) + 0.5F) / kBearings;
            const float flat = std::sqrt(1 - y * y);
            sum += glm::dvec3{radiance(glm::vec3{flat * std::sin(turn), y, -flat * std::cos(turn)})};
        }
    }
    return kPi * glm::vec3{sum / static_cast<double>(kHeights * kBearings)};
}

// Luminance in kcd/m2 and chromaticity at the zenith, from the formulas of the paper's appendix worked out by hand.
TEST(Preetham, HasThePapersZenithAtThreeTurbiditiesAndSunHeights) {
    struct Row {
        float turbidity, sun_deg;
        glm::vec3 zenith;
    };
    for (const Row& row : {Row{2, 15, {2.6989F, 0.2497F, 0.2594F}}, Row{2, 40, {4.1100F, 0.2388F, 0.2416F}},
                           Row{2, 70, {7.3674F, 0.2591F, 0.2656F}}, Row{4, 15, {4.0083F, 0.2624F, 0.2777F}},
                           Row{4, 40, {8.8063F, 0.2502F, 0.2594F}}, Row{4, 70, {19.1914F, 0.2618F, 0.2710F}},
                           Row{6, 15, {5.1701F, 0.2755F, 0.2950F}}, Row{6, 40, {12.9795F, 0.2621F, 0.2768F}},
                           Row{6, 70, {28.9194F, 0.2673F, 0.2802F}}}) {
        const Preetham model(row.turbidity, toward(0, row.sun_deg));
        for (const glm::vec3& seen : {model.zenith_yxy(), model.yxy({0, 1, 0})}) {
            EXPECT_NEAR(seen.x, row.zenith.x, 2e-3F * row.zenith.x) << row.turbidity << " " << row.sun_deg;
            EXPECT_NEAR(seen.y, row.zenith.y, 3e-4F);
            EXPECT_NEAR(seen.z, row.zenith.z, 3e-4F);
        }
    }
}

TEST(Preetham, IsAlikeOnBothSidesOfTheSunAndBrightestBesideIt) {
    const Preetham model(3, toward(70, 35));
    for (const float aside : {20.0F, 60.0F, 140.0F})
        EXPECT_NEAR(model.radiance(toward(70 + aside, 25)).g, model.radiance(toward(70 - aside, 25)).g, 1e-5F);
    EXPECT_GT(model.radiance(toward(70, 35)).g, 2 * model.radiance(toward(250, 55)).g);
}

TEST(Atmosphere, HasTheReferenceCoefficients) {
    const Atmosphere clean({.turbidity = 1, .molecules = 1, .ozone = 0});
    EXPECT_NEAR(clean.rayleigh_per_m().r, 5.802e-6F, 1e-9F);
    EXPECT_NEAR(clean.rayleigh_per_m().g, 13.558e-6F, 1e-9F);
    EXPECT_NEAR(clean.rayleigh_per_m().b, 33.1e-6F, 1e-9F);
    EXPECT_EQ(clean.haze_per_m(), 0);
    // Straight up, air of scale height H above an eye 200 m high is a column of H exp(-200 / H).
    const glm::vec3 through = clean.transmittance(1);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(through[c], std::exp(-clean.rayleigh_per_m()[c] * 8000 * std::exp(-200.0F / 8000)), 2e-3F);
}

TEST(Atmosphere, ReddensAndDimsTheSunAsItSinks) {
    const Atmosphere air(Air{});
    glm::vec3 before = air.transmittance(1);
    for (float deg = 80; deg >= 0; deg -= 5) {
        const glm::vec3 now = air.transmittance(std::sin(glm::radians(deg)));
        EXPECT_LT(luminance(now), luminance(before)) << deg;
        EXPECT_LE(now.b / now.r, before.b / before.r + 1e-4F) << deg;
        before = now;
    }
    EXPECT_EQ(air.transmittance(-0.2F), glm::vec3{0});
    // Kasten & Young's air mass at the horizon is 38: half of a day's light of clean air's red is left, no blue.
    const glm::vec3 rim = Atmosphere({.turbidity = 1, .molecules = 1, .ozone = 0}).transmittance(0.0F);
    EXPECT_NEAR(rim.r, std::exp(-5.802e-6F * 8000 * 36), 0.06F);
    EXPECT_LT(rim.b, 0.01F);
}

TEST(Atmosphere, SendsDownNoMoreLightThanTheSunDoes) {
    for (const float turbidity : {1.0F, 2.5F, 5.0F, 9.0F}) {
        const Atmosphere air({.turbidity = turbidity, .ground = 0.2F});
        for (const float deg : {10.0F, 30.0F, 60.0F, 90.0F}) {
            const glm::vec3 sun = toward(0, deg);
            const glm::vec3 sky = level_irradiance([&](const glm::vec3& d) { return air.radiance(d, sun); });
            const glm::vec3 all = sky + air.transmittance(sun.y) * sun.y;
            for (int c = 0; c < 3; ++c) {
                EXPECT_LT(all[c], 1.05F * sun.y) << turbidity << " " << deg << " " << c;
                // Of what haze takes it keeps a tenth; what is lost else goes back to space.
                EXPECT_GT(all[c], (turbidity < 3 && deg > 20 ? 0.5F : 0.15F) * sun.y) << turbidity << " " << deg;
            }
        }
    }
}

// Where the analytic sky holds, the two agree as well as it does with measurements; where it fails, ours does not.
TEST(Atmosphere, AgreesWithPreethamByDayAndGoesOnWhereHeEnds) {
    for (const float deg : {25.0F, 45.0F, 65.0F}) {
        const glm::vec3 sun = toward(0, deg);
        const Atmosphere air({.turbidity = 3});
        const Preetham model(3, sun);
        const float ours = luminance(level_irradiance([&](const glm::vec3& d) { return air.radiance(d, sun); }));
        const float his = luminance(level_irradiance([&](const glm::vec3& d) { return model.radiance(d); }));
        EXPECT_GT(ours, 0.45F * his) << deg;
        EXPECT_LT(ours, 2.2F * his) << deg;
    }
    const Atmosphere thick({.turbidity = 9});
    float before = 1e9F;
    for (const float deg : {8.0F, 2.0F, 0.0F, -3.0F, -6.0F, -9.0F}) {
        const glm::vec3 sun = toward(0, deg);
        float all = 0;
        for (const float height : {2.0F, 20.0F, 60.0F, 90.0F})
            for (const float bearing : {0.0F, 90.0F, 180.0F}) {
                const glm::vec3 seen = thick.radiance(toward(bearing, height), sun);
                for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(seen[c]) && seen[c] >= 0) << deg;
                all += luminance(seen);
            }
        EXPECT_LT(all, before) << deg;
        before = all;
    }
    EXPECT_GT(before, 0);
}

// At sunset the horizon under the sun is red and the zenith is not.
TEST(Atmosphere, IsRedderUnderALowSunThanAbove) {
    const Atmosphere air(Air{});
    const glm::vec3 sun = toward(0, 1);
    const glm::vec3 low = air.radiance(toward(0, 1), sun);
    const glm::vec3 high = air.radiance({0, 1, 0}, sun);
    EXPECT_GT(low.r, 1.5F * low.b);
    EXPECT_GT(high.b, high.r);
}

TEST(Irradiance, IsExactForWhatTheFirstThreeOrdersHold) {
    scene::Irradiance even;
    scene::Irradiance slanted;
    constexpr int kN = 64;
    for (int i = 0; i < kN; ++i) {
        const float y = -1 + 2 * (static_cast<float>(i) + 0.5F) / kN;
        for (int k = 0; k < kN; ++k) {
            const float turn = 2 * kPi * (static_cast<float>(k) + 0.5F) / kN;
            const glm::vec3 d{std::sqrt(1 - y * y) * std::sin(turn), y, -std::sqrt(1 - y * y) * std::cos(turn)};
            even.add(d, glm::vec3{0.7F}, 4 * kPi / (kN * kN));
            slanted.add(d, glm::vec3{1 + 0.6F * d.x - 0.3F * d.y}, 4 * kPi / (kN * kN));
        }
    }
    for (const glm::vec3& n : {glm::vec3{0, 1, 0}, glm::vec3{1, 0, 0}, glm::normalize(glm::vec3{1, -2, 0.5F})}) {
        EXPECT_NEAR(even.on(n).g, 0.7F, 2e-3F);
        // A linear radiance a + b·d gives a + 2/3 b·n.
        EXPECT_NEAR(slanted.on(n).g, 1 + (0.6F * n.x - 0.3F * n.y) * 2 / 3, 4e-3F);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(glm::dot(slanted.linear()[c], glm::vec4(n, 1)), slanted.on(n)[static_cast<int>(c)], 4e-3F);
    }
}

TEST(Irradiance, LeavesAWallThatLooksAwayFromTheGlowAShareOfTheMean) {
    scene::Irradiance glow;  // all of it from the east, low
    for (const float up : {0.0F, 0.1F, 0.2F})
        glow.add(glm::normalize(glm::vec3{1, up, 0}), glm::vec3{2, 1, 0.2F}, 0.4F);
    for (const glm::vec4& row : glow.linear())
        for (int i = 0; i < 12; ++i) {
            const float turn = 0.5235988F * static_cast<float>(i);
            EXPECT_GE(glm::dot(row, glm::vec4(std::sin(turn), 0, std::cos(turn), 1)), 0.33F * row.w);
        }
}

TEST(Irradiance, LeavesNothingBlackWhichWayItLooks) {
    scene::Irradiance dusk;  // a bright sky, brighter in the east, over dark ground
    constexpr int kN = 24;
    for (int i = 0; i < kN; ++i)
        for (int k = 0; k < kN; ++k) {
            const float y = 2 * (static_cast<float>(i) + 0.5F) / kN - 1;
            const float turn = 2 * kPi * (static_cast<float>(k) + 0.5F) / kN;
            const float flat = std::sqrt(1 - y * y);
            const glm::vec3 d{flat * std::sin(turn), y, flat * std::cos(turn)};
            dusk.add(d, glm::vec3{y > 0 ? 1 + 2 * std::max(d.x, 0.0F) : 0.15F}, 4 * kPi / (kN * kN));
        }
    for (const glm::vec4& row : dusk.linear())
        for (const float steep : {-0.9F, -0.5F, 0.0F, 0.5F})
            for (int i = 0; i < 12; ++i) {
                const float turn = 0.5235988F * static_cast<float>(i);
                const float flat = std::sqrt(1 - steep * steep);
                const glm::vec4 way(flat * std::sin(turn), steep, flat * std::cos(turn), 1);
                EXPECT_GE(glm::dot(row, way), 0.09F * row.w) << steep << ", " << turn;
            }
}

TEST(Irradiance, AsALinearFormKeepsTheLightFromAboveAndBelow) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{3});
    const scene::Sky sky = grow_sky(scene::realise_sky(recipe.values), recipe.seeds[genome::Aspect::Sky]);
    for (const glm::vec3& n : {glm::vec3{0, 1, 0}, glm::vec3{0, -1, 0}})
        for (std::size_t c = 0; c < 3; ++c) {
            const float exact = sky.ambient.on(n)[static_cast<int>(c)];
            EXPECT_NEAR(glm::dot(sky.ambient.linear()[c], glm::vec4(n, 1)), exact, 0.2F * exact);
        }
}

// Energy: a white, level ground without anything on it sends back what falls on it, by an integral of its own.
TEST(BakedLight, OfAWhiteGroundIsTheIrradianceOfSunAndSkyWithinTwoPercent) {
    scene::Land land;
    land.height_m = mesh::Field(65, 65, 5);
    land.cell_m = 2;
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::Sky sky = grow_sky(scene::realise_sky(recipe.values), recipe.seeds[genome::Aspect::Sky]);
        if (sky.is_night) continue;  // the eye opens a night's shadows
        const LandShadow shadow(land, sky.sun_direction);
        const scene::BakedLight baked = bake_light(land, openness_of(land), sky, {}, {}, shadow, 32);
        const glm::vec3 expected =
            level_irradiance([&](const glm::vec3& d) { return scene::mean_radiance(sky, d); }) / kPi +
            sky.sunlight * sky.sun_direction.y;
        for (int c = 0; c < 3; ++c) {
            if (expected[c] > 1.9F) continue;  // a byte holds no more
            const float light = static_cast<float>(baked.ground.pixel(16, 16)[c]) / 127.5F;
            EXPECT_NEAR(light, expected[c], 0.02F * expected[c] + 0.5F / 127.5F) << seed << " " << c;
            ++compared;
        }
    }
    EXPECT_GT(compared, 40);
}

TEST(Clouds, HideTheShareOfTheSkyTheyAreAskedFor) {
    for (const float cover : {0.0F, 0.15F, 0.4F, 0.7F, 0.85F}) {
        for (const float billow : {0.0F, 1.0F}) {
            CloudShape shape;
            shape.side_px = 256;
            shape.cover = cover;
            shape.billow = billow;
            const CloudImages clouds = make_clouds(shape, toward(30, 40), base::Seed{9});
            const auto covered = std::ranges::count_if(clouds.density.bytes, [](std::uint8_t b) { return b > 0; });
            EXPECT_NEAR(static_cast<double>(covered) / (256.0 * 256.0), cover, 0.03) << billow;
        }
    }
}

TEST(Clouds, TileWithoutASeam) {
    CloudShape shape;
    shape.side_px = 256;
    shape.cover = 0.6F;
    shape.clumps = 1;
    const CloudImages clouds = make_clouds(shape, toward(130, 20), base::Seed{4});
    const auto steps = [&](int from, int to) {
        double sum = 0;
        for (int y = 0; y < 256; ++y)
            sum += std::abs(int{*clouds.density.pixel(from, y)} - int{*clouds.density.pixel(to, y)});
        return sum / 256;
    };
    double usual = 0;
    for (int x = 0; x < 255; ++x) usual = std::max(usual, steps(x, x + 1));
    EXPECT_LE(steps(255, 0), usual);
}

TEST(Clouds, AreBrighterOnTheSunsSide) {
    CloudShape shape;
    shape.side_px = 256;
    shape.cover = 0.35F;
    shape.sharpness = 0.8F;
    const CloudImages east = make_clouds(shape, toward(90, 20), base::Seed{6});
    const CloudImages west = make_clouds(shape, toward(-90, 20), base::Seed{6});
    // On eastern rims density falls toward the east.
    double on_eastern_rims = 0;
    double on_western_rims = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 2; x < 254; ++x) {
            const int slope = int{*east.density.pixel(x + 2, y)} - int{*east.density.pixel(x - 2, y)};
            const int gain = int{*east.lit.pixel(x, y)} - int{*west.lit.pixel(x, y)};
            if (slope < -60) on_eastern_rims += gain;
            if (slope > 60) on_western_rims += gain;
        }
    EXPECT_GT(on_eastern_rims, 0);
    EXPECT_LT(on_western_rims, 0);
}

TEST(Moon, ShowsTheShareOfItsDiscThatIsLit) {
    for (const float phase : {0.12F, 0.3F, 0.5F, 0.75F, 1.0F}) {
        const mesh::Image moon = moon_picture(128, phase, base::Seed{1});
        double lit = 0;
        double disc = 0;
        for (std::size_t i = 0; i < moon.bytes.size(); i += 2) {
            const std::uint8_t b = moon.bytes[i];
            lit += b > 70 ? 1 : 0;
            disc += b > 0 ? 1 : 0;
        }
        EXPECT_NEAR(lit / disc, phase, 0.06) << phase;
    }
}

TEST(Moon, HidesTheSkyBehindItsLitPartAndTheSunDoesNot) {
    const mesh::Image half = moon_picture(128, 0.5F, base::Seed{1});
    EXPECT_EQ(half.pixel(96, 64)[1], 255);
    EXPECT_LT(half.pixel(32, 64)[1], 5);
    EXPECT_EQ(half.pixel(1, 1)[1], 0);
    const mesh::Image sun = sun_picture(64);
    for (std::size_t i = 1; i < sun.bytes.size(); i += 2) ASSERT_EQ(sun.bytes[i], 0);
}

TEST(Moon, HasSeas) {
    const mesh::Image full = moon_picture(128, 1, base::Seed{1});
    std::uint8_t darkest = 255;
    std::uint8_t lightest = 0;
    for (int y = 40; y < 88; ++y) {
        for (int x = 40; x < 88; ++x) {
            darkest = std::min(darkest, full.pixel(x, y)[0]);
            lightest = std::max(lightest, full.pixel(x, y)[0]);
        }
    }
    EXPECT_GT(lightest, 245);
    EXPECT_LT(darkest, 210);
}

TEST(Stars, ComeOnlyByNightAndThreeTimesAsManyForEachMagnitude) {
    scene::SkyParameters p;
    EXPECT_TRUE(make_stars(p, 0, base::Seed{1}).empty());
    p.star_band = 0;
    p.star_density = 1;
    const auto stars = make_stars(p, 1, base::Seed{1});
    EXPECT_TRUE(std::ranges::is_sorted(stars, [](const auto& a, const auto& b) { return a.light > b.light; }));
    // Light is 10^(-0.4 · 0.45 · magnitude): a magnitude is a factor of 0.66.
    const auto brighter_than = [&](float light) {
        return std::ranges::count_if(stars, [&](const scene::Star& s) { return s.light > light; });
    };
    const double faint = static_cast<double>(brighter_than(0.075F));
    const double bright = static_cast<double>(brighter_than(0.075F / 0.6607F));
    EXPECT_GT(faint, 200);
    EXPECT_NEAR(faint / bright, std::sqrt(10.0), 0.6);
}

TEST(Sky, HasARainbowOnlyWhereOneCanBe) {
    scene::SkyParameters p;
    p.bow_strength = 1;
    p.cloud_cover = 0.4F;
    p.sun_elevation_deg = 20;
    EXPECT_GT(grow_sky(p, base::Seed{1}).bow, 0.3F);
    p.sun_elevation_deg = 50;  // it would lie under the horizon
    EXPECT_EQ(grow_sky(p, base::Seed{1}).bow, 0);
    p.sun_elevation_deg = 20;
    p.night_share = 0.5F;
    EXPECT_EQ(grow_sky(p, base::Seed{1}).bow, 0);
    p.night_share = -1;
    p.snowfall_share = 0.5F;
    EXPECT_EQ(grow_sky(p, base::Seed{1}).bow, 0);
    p.snowfall_share = -1;
    p.cloud_cover = 0.1F;  // no cloud that it could rain from
    EXPECT_EQ(grow_sky(p, base::Seed{1}).bow, 0);
    p.rain_share = 0.3F;
    EXPECT_GT(grow_sky(p, base::Seed{1}).bow, 0.3F);
}

TEST(Sky, HasThinnerMistByNight) {
    scene::SkyParameters p;
    EXPECT_EQ(grow_sky(p, base::Seed{1}).mist.per_m, 0);
    p.mist_share = 0.5F;
    const float by_day = grow_sky(p, base::Seed{1}).mist.per_m;
    p.night_share = 0.7F;
    const float by_night = grow_sky(p, base::Seed{1}).mist.per_m;
    EXPECT_GT(by_night, 0.3F * by_day);
    EXPECT_LT(by_night, 0.5F * by_day);
}

TEST(Sky, LetsNoRainFallFlatterThanThirtyDegreesFromUpright) {
    scene::SkyParameters p;
    p.rain_share = 1;
    float before = -1;
    for (const float wind : {0.0F, 4.0F, 12.0F, 40.0F}) {
        p.cloud_wind_m_s = wind;
        p.rain_slant = 1;
        const scene::Precipitation rain = grow_sky(p, base::Seed{1}).precipitation;
        ASSERT_EQ(rain.kind, scene::Precipitation::Kind::Rain);
        const float slant = std::hypot(rain.speed_m_s.x, rain.speed_m_s.z) / -rain.speed_m_s.y;
        EXPECT_LE(slant, 0.58F);
        EXPECT_GT(slant, before) << "more wind, more slant";
        before = slant;
    }
}

TEST(Sky, ThatIsClosedTakesTheSunAndLeavesTheLight) {
    scene::SkyParameters clear;
    clear.cloud_cover = 0.1F;
    scene::SkyParameters closed = clear;
    closed.cloud_cover = 1;
    closed.cloud_thickness = 1;
    const scene::Sky a = grow_sky(clear, base::Seed{2});
    const scene::Sky b = grow_sky(closed, base::Seed{2});
    EXPECT_LT(luminance(b.sunlight), 0.4F * luminance(a.sunlight));
    EXPECT_GT(luminance(b.ambient.on({0, 1, 0})), 0.4F * luminance(a.ambient.on({0, 1, 0})));
    EXPECT_EQ(b.cloud_shadow, 0);
}

TEST(Sky, OfANightIsDarkerThanItsLandByMoonlight) {
    scene::SkyParameters p;
    p.night_share = 1;
    const scene::Sky night = grow_sky(p, base::Seed{2});
    EXPECT_TRUE(night.is_night);
    EXPECT_GT(night.stars.size(), 300U);
    EXPECT_LT(luminance(night.dome.radiance({0, 1, 0})), 0.12F);
    EXPECT_GT(luminance(night.sunlight), luminance(night.dome.radiance({0, 1, 0})));
    EXPECT_NEAR(glm::dot(night.sun_direction, toward(p.moon_azimuth_deg, p.moon_elevation_deg)), 1, 1e-5);
}

TEST(Sky, OfALowMoonReddensNoLand) {
    scene::SkyParameters p;
    p.night_share = 1;
    p.moon_elevation_deg = 8;
    p.moon_warmth = 0;
    const scene::Sky night = grow_sky(p, base::Seed{2});
    EXPECT_GE(night.sunlight.b, night.sunlight.r);
    p.night_share = 0;
    p.sun_elevation_deg = 8;
    const scene::Sky day = grow_sky(p, base::Seed{2});
    EXPECT_GT(day.sunlight.r, 1.5F * day.sunlight.b) << "a low sun does";
}

}  // namespace
}  // namespace quadrat::synthesis::sky
