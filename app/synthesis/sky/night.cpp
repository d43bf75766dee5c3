// SPDX-License-Identifier: Apache-2.0
#include "synthesis/sky/night.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/sky_parameters.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::sky {
namespace {

std::uint8_t byte_of(float unit) { return static_cast<std::uint8_t>(255.0F * std::clamp(unit, 0.0F, 1.0F) + 0.5F); }

struct OnDisc {
    float light;
    float hides;
};

// Calls with each pixel's place, -1 to 1 from the picture's middle; the disc fills nine tenths of it.
template <typename Look>
mesh::Image disc_picture(int side_px, const Look& look) {
    constexpr float kFilled = 0.9F;
    mesh::Image picture(side_px, side_px, 2);
    const float per_px = 2.0F / (kFilled * static_cast<float>(side_px));
    for (int y = 0; y < side_px; ++y) {
        for (int x = 0; x < side_px; ++x) {
            const glm::vec2 at{(static_cast<float>(x) + 0.5F) * per_px - 1.0F / kFilled,
                               1.0F / kFilled - (static_cast<float>(y) + 0.5F) * per_px};
            const float edge = std::clamp((1.0F - glm::length(at)) / (2.0F * per_px) + 0.5F, 0.0F, 1.0F);
            const OnDisc seen = look(at);
            picture.pixel(x, y)[0] = byte_of(edge * seen.light);
            picture.pixel(x, y)[1] = byte_of(edge * seen.hides);
        }
    }
    return picture;
}

float magnitude_light(float magnitude) { return std::pow(10.0F, -0.4F * magnitude); }

glm::vec3 anywhere(base::RandomStream& random) {
    const float turn = 6.2831853F * random.unit_f();
    const float y = random.unit_f();
    const float flat = std::sqrt(1.0F - y * y);
    return {flat * std::sin(turn), y, -flat * std::cos(turn)};
}

glm::vec3 in_the_band(base::RandomStream& random, float tilt_rad) {
    const glm::vec3 pole = glm::normalize(glm::vec3{std::cos(tilt_rad), 0.35F, std::sin(tilt_rad)});
    const glm::vec3 a = glm::normalize(glm::cross(pole, glm::vec3{0, 1, 0}));
    const glm::vec3 b = glm::cross(pole, a);
    const float turn = 6.2831853F * random.unit_f();
    return glm::normalize(std::cos(turn) * a + std::sin(turn) * b + 0.11F * random.normal() * pole);
}

}  // namespace

mesh::Image sun_picture(int side_px) {
    return disc_picture(side_px, [](const glm::vec2& at) {
        const float cosine = std::sqrt(std::max(1.0F - glm::dot(at, at), 0.0F));
        return OnDisc{0.4F + 0.6F * cosine, 0};  // limb darkening; its light comes on top of the sky's
    });
}

mesh::Image moon_picture(int side_px, float phase, base::Seed seed) {
    const noise::Key key(seed.child("seas"));
    // The terminator is half an ellipse: its half axis goes from +1 (new) over 0 (half) to -1 (full).
    const float terminator = 1.0F - 2.0F * std::clamp(phase, 0.0F, 1.0F);
    return disc_picture(side_px, [&](const glm::vec2& at) {
        const float rim = std::sqrt(std::max(1.0F - at.y * at.y, 0.0F));
        const float day = std::clamp(0.5F + (at.x - terminator * rim) * 9.0F, 0.0F, 1.0F);
        const float seas = noise::fbm(key, 1.9F * at.x + 5.0F, 1.9F * at.y + 5.0F, {.count = 4, .gain = 0.5F});
        const float ground = 1.0F - 0.26F * std::clamp(3.2F * seas, 0.0F, 1.0F);
        // Added to a sky that it lights up itself, its seas would be as white as all else.
        return OnDisc{ground * (0.045F + 0.955F * day), day};
    });
}

std::vector<scene::Star> make_stars(const scene::SkyParameters& p, float darkness, base::Seed seed) {
    std::vector<scene::Star> stars;
    constexpr float kFirst = 0.3F;       // darkness: the sun 4 degrees down, while the sky is blue
    constexpr float kBrightest = -1.0F;  // magnitudes
    constexpr float kFirstSeen = 0.5F;
    if (darkness <= kFirst) return stars;
    const float night = (darkness - kFirst) / (1 - kFirst);
    const float faintest = glm::mix(kFirstSeen, 3.2F + 3.3F * p.star_density, std::sqrt(night));
    // About 1.7 stars of a hemisphere are brighter than magnitude 0.5; for every magnitude more there are 3.1 times as
    // many.
    const float many = 0.9F * std::pow(10.0F, 0.5F * faintest);
    const auto count = static_cast<std::size_t>(many * (1.0F + 0.6F * p.star_band));
    base::RandomStream random{seed.child("stars")};
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_banded = static_cast<float>(i) > many;
        const glm::vec3 direction = is_banded ? in_the_band(random, glm::radians(p.star_band_deg)) : anywhere(random);
        const float magnitude = std::max(faintest + 2.0F * std::log10(std::max(random.unit_f(), 1.0e-5F)), kBrightest);
        if (direction.y < 0.02F) continue;
        // The faintest are a tenth as bright as a bright one: an eye's scale is flatter than light's.
        const float light = std::pow(magnitude_light(magnitude - kBrightest), 0.45F);
        stars.push_back({direction, light * (is_banded ? 0.7F : 1.0F) * (0.25F + 0.75F * night)});
    }
    std::ranges::stable_sort(stars, [](const scene::Star& a, const scene::Star& b) { return a.light > b.light; });
    return stars;
}

}  // namespace quadrat::synthesis::sky
