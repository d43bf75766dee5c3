// SPDX-License-Identifier: Apache-2.0
// The sky as physics has it (atmosphere.hpp, preetham.hpp), then as an illustrator would: shadows opened, colours
// deepened or paled in OKLab, the whole exposed for its hour.
#include "synthesis/sky/daylight.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "mesh/field.hpp"
#include "scene/colour.hpp"
#include "scene/sky_parameters.hpp"
#include "synthesis/sky/atmosphere.hpp"
#include "synthesis/sky/preetham.hpp"

namespace quadrat::synthesis::sky {
namespace {

using scene::Dome;
using Parameters = scene::SkyParameters;

constexpr float kPi = std::numbers::pi_v<float>;
// Of the sun's light; a hundred times the true moon's, because an eye would have adapted and a picture cannot.
constexpr float kMoonlight = 2.5e-4F;
constexpr float kLeastBlue = 0.85F;  // of a night: a green meadow under stars is a day that has gone wrong
constexpr float kFill = 1.95F;       // how far an illustrator opens the shadows

float brightest(const glm::vec3& c) { return std::max({c.x, c.y, c.z, 1.0e-9F}); }

glm::vec3 toward(float azimuth_deg, float elevation_deg) {
    const float a = glm::radians(azimuth_deg);
    const float h = glm::radians(elevation_deg);
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
}

// Toward amber or rose for warmth > 0, toward blue for less; the brightness stays.
glm::vec3 warmed(const glm::vec3& colour, float warmth, const glm::vec3& warm, const glm::vec3& cool) {
    const glm::vec3 tint = glm::mix(glm::vec3{1}, warmth > 0 ? warm : cool, std::abs(warmth));
    const glm::vec3 tinted = colour * tint;
    return tinted * (scene::luminance(colour) / std::max(scene::luminance(tinted), 1.0e-9F));
}

constexpr glm::vec3 kAmber{1.28F, 0.93F, 0.48F};
constexpr glm::vec3 kColdLight{0.84F, 0.98F, 1.25F};
constexpr glm::vec3 kRose{1.38F, 0.90F, 0.86F};
constexpr glm::vec3 kBlue{0.62F, 0.96F, 1.45F};
constexpr glm::vec3 kMoonBlue{0.46F, 0.88F, 1.75F};

Air air_of(const Parameters& p) { return {p.air_turbidity, p.air_molecules, p.air_ozone, p.air_forward, p.air_ground}; }

// Radiance by bearing from the light, 0 to 180 degrees, and by the dome's heights: a clear sky is alike on both sides.
class HalfDome {
  public:
    template <typename Radiance>
    HalfDome(const glm::vec3& light, const Radiance& radiance) : table_(kBearings, Dome::kRows) {
        azimuth_ = std::atan2(light.x, -light.z);
        const glm::vec3 turned{0, light.y, -std::hypot(light.x, light.z)};
        for (int y = 0; y < Dome::kRows; ++y)
            for (int x = 0; x < kBearings; ++x) table_.at(x, y) = radiance(Dome::direction(x, y), turned);
    }
    glm::vec3 at(const glm::vec3& direction, int row) const {
        float apart = std::atan2(direction.x, -direction.z) - azimuth_;
        apart = std::abs(std::remainder(apart, 2.0F * kPi));
        const float column = apart / kPi * (kBearings - 1);
        const int x = std::min(static_cast<int>(column), kBearings - 2);
        return glm::mix(table_.at(x, row), table_.at(x + 1, row), column - static_cast<float>(x));
    }

  private:
    static constexpr int kBearings = (Dome::kColumns + 1) / 2;
    mesh::Grid<glm::vec3> table_;
    float azimuth_ = 0;
};

float preetham_share(const Parameters& p, const Lights& lights) {
    if (lights.is_night) return 0;
    return std::max(p.air_preetham, 0.0F) * glm::smoothstep(5.0F, 12.0F, lights.sun_height_deg) *
           (1.0F - glm::smoothstep(5.5F, 8.0F, p.air_turbidity));
}

HalfDome sunlit_dome(const Parameters& p, const Lights& lights, const Atmosphere& atmosphere) {
    const float share = preetham_share(p, lights);
    const auto model = [&](const glm::vec3& sun) { return Preetham(std::max(p.air_turbidity, 2.0F), sun); };
    return {lights.sun, [&](const glm::vec3& direction, const glm::vec3& sun) {
                const glm::vec3 scattered = atmosphere.radiance(direction, sun);
                if (share <= 0) return scattered;
                return glm::mix(scattered, model(sun).radiance(direction), share);
            }};
}

template <typename At>
void fill(Dome& dome, const At& at) {
    for (int row = 0; row < Dome::kRows; ++row)
        for (int column = 0; column < Dome::kColumns; ++column)
            dome.at(column, row) = at(Dome::direction(column, row), column, row);
}

// Irradiance / pi on level ground; the rows' own widths as the measure.
glm::vec3 level_light(Dome& dome) {
    glm::vec3 sum{0};
    for (int row = 0; row < Dome::kRows; ++row) {
        const auto edge = [row](float by) {
            const float y = std::clamp(static_cast<float>(row) + by, 0.0F, static_cast<float>(Dome::kRows - 1));
            const float up = 1.0F - y / static_cast<float>(Dome::kRows - 1);
            const float sine = std::sin(0.5F * kPi * up * up);
            return sine * sine;
        };
        const float share = (edge(-0.5F) - edge(0.5F)) / static_cast<float>(Dome::kColumns - 1);
        for (int column = 0; column + 1 < Dome::kColumns; ++column) sum += dome.at(column, row) * share;
    }
    return sum;
}

// The Milky Way: a band across the whole sky, uneven along its way.
glm::vec3 galaxy(const Parameters& p, const glm::vec3& direction) {
    const float tilt = glm::radians(p.star_band_deg);
    const glm::vec3 pole{std::cos(tilt), 0.35F, std::sin(tilt)};
    const float off = glm::dot(direction, glm::normalize(pole));
    const float along = std::atan2(direction.z, direction.x);
    const float patches = 0.75F + 0.25F * std::sin(5.0F * along + 2.0F * std::sin(3.0F * along));
    const float rift = 1.0F - 0.45F * std::exp(-off * off / 0.002F);
    return glm::vec3{0.78F, 0.86F, 1.0F} * (p.star_band * std::exp(-off * off / 0.026F) * patches * rift);
}

// Saturation as a painter allows a sky: blue and orange much, rose less, violet and green little.
glm::vec3 restrained(const glm::vec3& colour) {
    glm::vec3 lab = scene::oklab_from_linear(colour);
    const float chroma = std::hypot(lab.y, lab.z);
    if (chroma < 1.0e-5F) return colour;
    const float red = lab.y / chroma;     // 1 red to -1 green
    const float yellow = lab.z / chroma;  // 1 yellow to -1 blue
    const float warm = std::max(yellow, 0.0F) * glm::smoothstep(-0.5F, 0.3F, red);
    const float blue = std::max(-yellow, 0.0F) * glm::smoothstep(0.1F, -0.25F, red);
    const float most = (0.06F + 0.11F * warm + 0.12F * blue) * std::max(lab.x, 0.5F);
    const float allowed = most * std::tanh(chroma / most);
    lab.y *= allowed / chroma;
    lab.z *= allowed / chroma;
    return glm::max(scene::linear_from_oklab(lab), glm::vec3{0});
}

struct Grade {
    const Parameters& p;
    const Lights& lights;
    glm::vec2 flat_sun;

    // Near the horizon, in the sun's direction and opposite it: 0 to 1.
    float facing(const glm::vec3& d) const {
        const glm::vec2 flat{d.x, d.z};
        const float side = glm::dot(flat, flat_sun) / std::max(glm::length(flat), 1.0e-4F);
        return std::clamp(0.5F + 0.5F * side, 0.0F, 1.0F);
    }

    glm::vec3 operator()(glm::vec3 c, const glm::vec3& d) const {
        const float height = std::asin(std::clamp(d.y, 0.0F, 1.0F)) / (0.5F * kPi);
        const float near = std::exp(-7.0F * height);
        const float sunward = facing(d);
        if (lights.lowness > 0) {
            const float glows = near * std::pow(sunward, 2.5F) * lights.lowness;
            c *= glm::mix(1.0F, p.dusk_glow, std::min(glows * 1.6F, 1.0F));
            c = warmed(c, p.dusk_red * std::min(1.4F * glows, 1.0F), {1.55F, 0.72F, 0.55F}, {1.15F, 1.0F, 0.72F});
            const float belt = std::exp(-std::pow((height - 0.13F) / 0.08F, 2.0F)) * std::pow(1.0F - sunward, 1.5F);
            c = warmed(c, std::min(p.dusk_rose * belt * lights.lowness, 1.0F), {1.5F, 0.85F, 1.0F}, {1, 1, 1});
        }
        c = warmed(c, 0.55F * p.ambient_warmth, kRose, kBlue);
        c = warmed(c, p.haze_warmth * 0.75F * near, {1.25F, 0.96F, 0.60F}, kColdLight);
        const float deep = 2.0F * p.sky_depth - 1.0F;
        // A deep sky darkens upward; a pale one is lifted.
        c *= 1.0F + 0.14F - 0.42F * p.sky_depth * glm::smoothstep(0.05F, 0.8F, height);
        if (lights.is_night) {
            const glm::vec3 night =
                glm::mix(glm::vec3{0.85F, 0.95F, 1.2F}, glm::vec3{0.38F, 0.85F, 2.1F}, p.night_blue);
            c = glm::mix(c, night * (scene::luminance(c) / scene::luminance(night)), 0.8F * lights.darkness);
        }
        return restrained(scene::shifted_colour(glm::max(c, glm::vec3{0}), 1.0F, 1.22F + 0.46F * deep));
    }
};

// What an eye that has adapted sees about the moon, to its light: a glow over its side of the horizon, and a smaller
// one.
float about_moon(const Lights& lights, const glm::vec3& direction) {
    const float near = std::max(glm::dot(direction, lights.moon), 0.0F);
    const float low = std::exp(-3.5F * std::max(direction.y, 0.0F));
    return 0.030F * std::pow(near, 3.0F) * low + 0.10F * std::pow(near, 60.0F);
}

// A sky all white has nothing to look at: it gives way to the land it lights.
template <typename Dome>
void dim_white_sky(Dome& dome) {
    constexpr float kMost = 0.60F;
    const float bright = scene::luminance(level_light(dome));
    if (bright <= kMost) return;
    const float less = std::pow(kMost / bright, 0.75F);
    fill(dome, [&](const glm::vec3&, int column, int row) { return dome.at(column, row) * less; });
}

}  // namespace

float overcast(const Parameters& p) {
    return glm::smoothstep(0.55F, 0.97F, p.cloud_cover) * (0.45F + 0.55F * p.cloud_thickness);
}

Lights::Lights(const Parameters& p)
    : moon(toward(p.moon_azimuth_deg, p.moon_elevation_deg)), is_night(p.night_share > 0) {
    // The hour of nightfall takes the sun from the horizon down to where it gives no more light.
    sun_height_deg = is_night ? 0.5F - 14.5F * p.night_share : p.sun_elevation_deg;
    sun = toward(p.sun_azimuth_deg, sun_height_deg);
    darkness = glm::smoothstep(0.0F, -11.0F, sun_height_deg);
    lowness = 1.0F - glm::smoothstep(4.0F, 30.0F, sun_height_deg);
}

Daylight make_daylight(const Parameters& p, const Lights& lights) {
    Daylight day;
    const Atmosphere atmosphere(air_of(p));
    const HalfDome by_sun = sunlit_dome(p, lights, atmosphere);
    fill(day.dome, [&](const glm::vec3& d, int, int row) { return by_sun.at(d, row); });
    const float strength = p.sun_strength;
    glm::vec3 light = glm::pow(atmosphere.transmittance(lights.sun.y), glm::vec3{0.8F}) * strength;
    glm::vec3 high = glm::pow(atmosphere.transmittance(lights.sun.y + 0.04F), glm::vec3{0.75F}) * strength;
    if (lights.is_night) {
        const float moon = kMoonlight * p.moon_strength * (0.35F + 0.65F * p.moon_phase);
        // An eye sees no haze about a moon that it does about a sun.
        Air thin = air_of(p);
        thin.turbidity = 1.0F + 0.3F * (thin.turbidity - 1.0F);
        thin.forward = 0.5F * thin.forward;
        const Atmosphere dark(thin);
        const HalfDome by_moon(
            lights.moon, [&](const glm::vec3& d, const glm::vec3& m) { return 0.6F * moon * dark.radiance(d, m); });
        const glm::vec3 airglow = glm::vec3{0.55F, 0.75F, 1.15F} * (0.03F * kMoonlight);
        fill(day.dome, [&](const glm::vec3& d, int, int row) {
            return by_sun.at(d, row) + by_moon.at(d, row) + glm::vec3{p.moon_glow * moon * about_moon(lights, d)} +
                   airglow * (1.3F - 0.6F * d.y) + galaxy(p, d) * (0.055F * kMoonlight * lights.darkness);
        });
        const glm::vec3 through = glm::sqrt(dark.transmittance(lights.moon.y));
        // An eye sees no colour in so little light: a low moon reddens no land.
        light = moon * glm::mix(through, glm::vec3{scene::luminance(through)}, 0.85F * lights.darkness);
        light = warmed(light, p.moon_warmth, kAmber, kColdLight);
        // At nightfall the sky is red yet: blue trees before it would be out of place.
        light = warmed(light, lights.darkness * std::max(p.night_blue, kLeastBlue), kMoonBlue, kMoonBlue);
        high += 0.7F * light;
    } else {
        light = warmed(light, p.sun_warmth - 0.2F, kAmber, kColdLight);
    }
    const glm::vec3 level = level_light(day.dome);
    const float meter =
        scene::luminance(light) / kPi * std::max(lights.brightest().y, 0.28F) + kFill * scene::luminance(level);
    // A picture spans less than the world does: a thousandth of the light is shown at 0.4 of the brightness.
    const float key = std::max(1.27F * std::pow(meter / 0.33F, 0.15F), 0.30F);
    // Under closed clouds a camera opens, though not all the way: they should feel closed.
    day.exposure = std::exp2(p.light_exposure) * key / std::max(meter, 1.0e-9F) *
                   (1.0F + overcast(p) * (0.70F - 0.55F * p.cloud_thickness));

    const glm::vec2 flat{lights.sun.x, lights.sun.z};
    const Grade grade{p, lights, flat / std::max(glm::length(flat), 1.0e-4F)};
    // A night's sky is darker than what its moon lights, or no star would show.
    const float night_sky = glm::mix(1.0F, 0.17F, lights.darkness);
    const float fill_light = day.exposure * kFill * (0.5F + 0.5F * p.ambient_strength) * night_sky;
    fill(day.dome,
         [&](const glm::vec3& d, int column, int row) { return grade(day.dome.at(column, row) * fill_light, d); });
    dim_white_sky(day.dome);
    day.sunlight = light * (day.exposure / kPi);
    // A sun so low that its light alone would be one colour keeps a little of the others.
    day.sunlight = glm::mix(day.sunlight, glm::vec3{brightest(day.sunlight)} * glm::vec3{1, 0.62F, 0.34F},
                            lights.is_night ? 0.0F : 0.35F * lights.lowness);
    // More than this no surface shows.
    day.sunlight *= std::min(1.0F, 2.2F / brightest(day.sunlight));
    day.high_light = high * (day.exposure / kPi);
    day.sky_light = level_light(day.dome);
    return day;
}

}  // namespace quadrat::synthesis::sky
