// SPDX-License-Identifier: Apache-2.0
// Sunlight's colour: Beer's law through the optical mass of Kasten & Young, 1989, with depths for clear air.
#include "synthesis/sky/daylight.hpp"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "scene/colour.hpp"

namespace quadrat::synthesis::sky {
namespace {

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

glm::vec3 mix(const glm::vec3& a, const glm::vec3& b, float t) { return a + (b - a) * t; }

glm::vec3 clear_air(float elevation_deg) {
    const float mass =
        1.0F / (std::sin(glm::radians(elevation_deg)) + 0.50572F * std::pow(elevation_deg + 6.07995F, -1.6364F));
    const glm::vec3 depth{0.045F, 0.085F, 0.175F};
    return glm::exp(-depth * (mass - 1.0F));
}

float brightest(const glm::vec3& c) { return std::max({c.x, c.y, c.z, 1.0e-4F}); }

// Toward amber for warmth > 0, toward blue for less.
glm::vec3 warmed(const glm::vec3& colour, float warmth) {
    const glm::vec3 amber{1.12F, 0.93F, 0.66F};
    const glm::vec3 blue{0.84F, 0.97F, 1.22F};
    return colour * mix(glm::vec3{1}, warmth > 0 ? amber : blue, std::abs(warmth));
}

float forward_scatter(float cosine, float g) {
    const float d = 1.0F + g * g - 2.0F * g * cosine;
    return (1.0F - g) * (1.0F - g) * (1.0F - g) / (d * std::sqrt(d));  // 1 straight at the sun
}

}  // namespace

Daylight::Daylight(const scene::SkyParameters& p) {
    const float elevation = glm::radians(p.sun_elevation_deg);
    const float azimuth = glm::radians(p.sun_azimuth_deg);
    sun_ = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), -std::cos(elevation) * std::cos(azimuth)};
    lowness_ = 1.0F - smooth(4.0F, 30.0F, p.sun_elevation_deg);
    haziness_ = 1.0F - smooth(400.0F, 3600.0F, p.haze_distance_m);

    glm::vec3 sun = clear_air(p.sun_elevation_deg);
    sun = warmed(sun / std::pow(brightest(sun), 0.8F), 1.1F * p.sun_warmth);
    // Exposed for the hour: what a low sun lights aslant is not left in the dark.
    sunlight_ = sun * (p.sun_strength * (1.02F + 0.55F * lowness_));
    sun_colour_ = sun / brightest(sun);

    // Of a high sun, then of a low one; sRGB as one would mix them.
    const auto paint = [](std::uint32_t hex) { return scene::oklab_from_linear(scene::linear_from_srgb_hex(hex)); };
    const glm::vec3 zenith = mix(mix(paint(0x8FB4D2), paint(0x2C66AE), p.sky_depth),
                                 mix(paint(0x8D9CBC), paint(0x33508C), p.sky_depth), lowness_);
    const glm::vec3 middle = mix(mix(paint(0xB4CCDD), paint(0x6FA0D2), p.sky_depth),
                                 mix(paint(0xC3B9BE), paint(0x8C92B4), p.sky_depth), lowness_);
    glm::vec3 horizon = mix(mix(paint(0xDDE5E8), paint(0xC6DCEA), p.sky_depth), paint(0xE6C7A2), 0.85F * lowness_);
    const glm::vec3 warm_air = paint(0xEACB98);
    const glm::vec3 cold_air = paint(0xA8BACC);
    horizon = mix(horizon, p.haze_warmth > 0 ? warm_air : cold_air, 0.6F * std::abs(p.haze_warmth));
    // Thick air pales the whole dome.
    const float dim = 0.90F + 0.10F * std::min(p.ambient_strength, 1.2F) - 0.07F * lowness_;
    zenith_lab_ = mix(zenith, horizon, 0.30F * haziness_) * dim;
    middle_lab_ = mix(middle, horizon, 0.45F * haziness_) * dim;
    horizon_lab_ = horizon * dim;
    dusk_ = scene::linear_from_srgb_hex(0xD9A6A8) - scene::linear_from_srgb_hex(0xB8AFB8);
    glow_ = sun_colour_ * (0.35F + 0.45F * lowness_) * (0.6F + 0.5F * p.sun_strength);
}

glm::vec3 Daylight::radiance(const glm::vec3& direction) const {
    const float up = std::max(direction.y, 0.0F);
    const float altitude = std::asin(std::min(up, 1.0F)) / 1.5707963F;  // 0 horizon to 1 zenith
    const float near_horizon = std::exp(-altitude * (9.0F - 4.5F * haziness_));
    const float near_zenith = smooth(0.10F, 0.95F, std::sqrt(altitude));
    const glm::vec3 lab = mix(mix(middle_lab_, zenith_lab_, near_zenith), horizon_lab_, near_horizon);
    glm::vec3 colour = scene::linear_from_oklab(lab);

    const float toward_sun = glm::dot(direction, sun_);
    const glm::vec2 flat{direction.x, direction.z};
    const glm::vec2 flat_sun{sun_.x, sun_.z};
    const float side = std::clamp(
        glm::dot(flat, flat_sun) / std::max(glm::length(flat) * glm::length(flat_sun), 1.0e-4F), -1.0F, 1.0F);
    const float halo = 0.30F * forward_scatter(toward_sun, 0.55F) + 0.55F * forward_scatter(toward_sun, 0.86F);
    colour += glow_ * (halo * (0.55F + 0.45F * haziness_));
    // A low sun lights the air along the horizon beneath it, and leaves rose above the earth's shadow opposite.
    colour += glow_ * sun_colour_ * (0.35F * lowness_ * near_horizon * std::pow(0.5F + 0.5F * side, 3.0F));
    const float belt = std::exp(-std::pow((altitude - 0.10F) / 0.07F, 2.0F));
    colour += dusk_ * (0.9F * lowness_ * belt * std::pow(0.5F - 0.5F * side, 1.5F));
    // A shoulder, so that the glow never burns out.
    const glm::vec3 c = glm::max(colour, glm::vec3{0});
    return c / (1.0F + 0.18F * c * c);
}

}  // namespace quadrat::synthesis::sky
