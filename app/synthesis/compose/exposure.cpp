// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/exposure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <vector>

#include "scene/colour.hpp"
#include "synthesis/compose/low_ground.hpp"
#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kBrightest = 0.67F;   // that a picture may be, shown, on the mean
constexpr float kLeast = 0.72F;       // of what would be shown
constexpr float kLit = 0.60F;         // that the lit parts of a picture are, shown, at least,
constexpr float kLitByNight = 0.50F;  // and by night, which is to stay one,
constexpr float kMost = 2.1F;         // unless they would have to be shown so many times brighter
constexpr float kRange = 0.46F;       // of values; where there is less,
constexpr float kMostRaised = 1.22F;  // lit parts are to be shown brighter by at most so much
constexpr float kMostRaisedByNight = 1.15F;
constexpr float kLitShare = 0.93F;      // of the picture is no brighter than its lit parts
constexpr float kShownByLight = 0.45F;  // shown brightness follows light to about this power

// Nearly as the renderer's tone curve does.
float shown(float light) { return 0.95F * std::min(std::sqrt(std::max(light, 0.0F)), 1.05F); }

glm::vec3 linear(const std::uint8_t* encoded) {
    return glm::pow(glm::vec3{encoded[0], encoded[1], encoded[2]} / 255.0F, glm::vec3{2.2F});
}

struct Seen {
    const scene::Land& land;
    const scene::Sky& sky;
    const scene::BakedLight& light;
    float floor_m = 0;  // on which mist lies

    Seen(const scene::Land& of, const scene::Sky& under, const scene::BakedLight& lit, const scene::Track& track)
        : land(of), sky(under), light(lit) {
        if (sky.mist.per_m > 0) floor_m = low_ground_m(land, track);
    }

    // Around the land, taken to be level.
    float country(const glm::vec3& at) const {
        const glm::vec3 on_level = sky.ambient.on({0, 1, 0}) + sky.sunlight * std::max(sky.sun_direction.y, 0.0F);
        const mesh::Image& colours = land.surround_albedo;
        if (colours.bytes.empty()) return shown(scene::luminance(glm::min(land.far_colour * on_level, 1.1F)));
        const auto sample = [&](float along_m, int samples) {
            const float place = along_m / land.surround_cell_m + 0.5F * static_cast<float>(samples - 1);
            return std::clamp(static_cast<int>(place + 0.5F), 0, samples - 1);
        };
        const std::uint8_t* colour = colours.pixel(sample(at.x, colours.width), sample(at.z, colours.height));
        return shown(scene::luminance(glm::min(linear(colour) * on_level, 1.1F)));
    }
    float ground(const glm::vec3& at) const {
        const float u = at.x / land.side_m() + 0.5F;
        const float v = at.z / land.side_m() + 0.5F;
        if (std::min(u, v) < 0 || std::max(u, v) >= 1) return country(at);
        const auto across = [u](int size) { return static_cast<int>(u * static_cast<float>(size)); };
        const auto down = [v](int size) { return static_cast<int>(v * static_cast<float>(size)); };
        const std::uint8_t* lit = light.ground.pixel(across(light.ground.width), down(light.ground.height));
        const glm::u8vec3 albedo = land.albedo.colour(across(land.albedo.width()), down(land.albedo.height()));
        const glm::vec3 sent = linear(&albedo[0]) * (glm::vec3{lit[0], lit[1], lit[2]} * (2.0F / 255));
        return shown(scene::luminance(glm::min(sent, 1.1F)));
    }
    float along(const glm::vec3& eye, const glm::vec3& ray) const {
        const Hit hit = first_hit(land, eye, ray);
        if (hit.distance_m >= kFarthest_m)
            return shown(std::min(scene::luminance(scene::mean_radiance(sky, ray)), 0.9F));
        const float over_mist_m = eye.y + ray.y * hit.distance_m - floor_m - sky.mist.level_m;
        const float mist = sky.mist.per_m * std::exp(-std::max(over_mist_m, 0.0F) / std::max(sky.mist.depth_m, 1.0F));
        const float air = 1 - std::exp(-hit.distance_m * (1 / std::max(sky.haze_distance_m, 1.0F) + mist));
        const float water =
            shown(0.5F * scene::luminance(scene::mean_radiance(sky, {ray.x, std::abs(ray.y) + 0.2F, ray.z})));
        const float surface = hit.is_water ? water : ground(eye + ray * hit.distance_m);
        return glm::mix(surface, shown(scene::luminance(sky.haze_colour)), air);
    }
};

// What three views of the flight show.
std::vector<float> values_along(const Seen& seen, const scene::Track& track) {
    std::vector<float> values;
    for (const float share : {0.0F, 0.33F, 0.67F}) {
        const scene::Camera camera = scene::camera_at(track, share * track.period_s);
        for (const glm::vec3& ray : view_rays(camera)) values.push_back(seen.along(camera.eye_m, ray));
    }
    return values;
}

// Of which this share is no brighter.
float value_at(std::vector<float>& values, float share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<float>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// From the mean of the darkest tenth to that of the lightest: a single ray hits a shadow or misses it.
float range_of(std::vector<float>& values) {
    const auto tenth = static_cast<std::ptrdiff_t>(values.size() / 10);
    std::nth_element(values.begin(), values.begin() + tenth, values.end());
    std::nth_element(values.begin() + tenth, values.end() - tenth, values.end());
    const auto mean = [&](auto from) { return std::accumulate(from, from + tenth, 0.0F) / static_cast<float>(tenth); };
    return mean(values.end() - tenth) - mean(values.begin());
}

}  // namespace

float value_range(const scene::Land& land, const scene::Sky& sky, const scene::BakedLight& light,
                  const scene::Track& track) {
    if (land.albedo.is_empty() || light.ground.bytes.empty()) return 1;
    std::vector<float> values = values_along(Seen{land, sky, light, track}, track);
    return range_of(values);
}

float exposure_for(const scene::Land& land, const scene::Sky& sky, const scene::BakedLight& light,
                   const scene::Track& track) {
    if (land.albedo.is_empty() || light.ground.bytes.empty()) return 1;
    const Seen seen{land, sky, light, track};
    std::vector<float> values = values_along(seen, track);
    const float bright = std::accumulate(values.begin(), values.end(), 0.0F) / static_cast<float>(values.size());
    if (bright > kBrightest) return std::pow(std::max(kBrightest / bright, kLeast), 1 / kShownByLight);
    const float lit = value_at(values, kLitShare);
    // What has little between its light and its dark is shown brighter, and so has more.
    const float range = range_of(values);
    const float raised =
        std::clamp(kRange / std::max(range, 1.0e-3F), 1.0F, sky.is_night ? kMostRaisedByNight : kMostRaised);
    const float wanted = raised * (sky.is_night ? kLitByNight : kLit);
    if (lit >= wanted) return 1;
    // Something is lit in every picture, by night and under storms too.
    const float more = std::min({wanted / std::max(lit, 1.0e-3F), kMost, kBrightest / std::max(bright, 1.0e-3F)});
    return std::pow(more, 1 / kShownByLight);
}

}  // namespace quadrat::synthesis
