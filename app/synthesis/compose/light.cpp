// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/light.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/colour.hpp"
#include "scene/night_eye.hpp"
#include "scene/withering.hpp"
#include "synthesis/compose/crown_shadows.hpp"
#include "synthesis/compose/stone_shadows.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kNoShadow_m = -1.0e5F;
constexpr float kSoftness = 0.022F;  // of a shadow's edge, to its distance: wider than the sun's, as air makes it
constexpr float kDeepest_m = 24.0F;

template <typename Row>
void for_rows(int rows, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

// Takes away this share of the light where something hides all of it.
void darken(mesh::Field& light, const mesh::Field& hidden, float share) {
    for (std::size_t i = 0; i < hidden.samples.size(); ++i) light.samples[i] *= 1.0F - share * hidden.samples[i];
}

std::uint8_t half_byte(float linear) {
    return static_cast<std::uint8_t>(std::clamp(127.5F * linear + 0.5F, 0.0F, 255.0F));
}

}  // namespace

// A sweep away from the sun, a row (or column) after the other: what shades a sample is what shaded its neighbour
// toward the sun, lower by the ray's fall, or that neighbour itself.
LandShadow::LandShadow(const scene::Land& land, const glm::vec3& sun, float softness)
    : top_m_(land.height_m.columns, land.height_m.rows, kNoShadow_m),
      away_m_(land.height_m.columns, land.height_m.rows, 0.0F),
      cell_m_(land.cell_m),
      softness_(kSoftness * softness) {
    const bool by_rows = std::abs(sun.z) >= std::abs(sun.x);
    const float main = by_rows ? sun.z : sun.x;
    const float side = by_rows ? sun.x : sun.z;
    if (std::abs(main) < 1.0e-4F) return;  // the sun stands overhead
    const int n = land.height_m.columns;
    const float shift = side / std::abs(main);
    const float step_m = land.cell_m * std::sqrt(1.0F + shift * shift);
    const float fall_m = land.cell_m * sun.y / std::abs(main);
    const int first = main > 0 ? n - 1 : 0;
    const int stride = main > 0 ? -1 : 1;
    const auto at = [by_rows](auto& field, int along, int across) -> auto& {
        return by_rows ? field.at(across, along) : field.at(along, across);
    };
    for (int k = 1; k < n; ++k) {
        const int line = first + k * stride;
        const int before = line - stride;
        for (int i = 0; i < n; ++i) {
            const float from = std::clamp(static_cast<float>(i) + shift, 0.0F, static_cast<float>(n - 1));
            const int i0 = std::min(static_cast<int>(from), n - 2);
            const float t = from - static_cast<float>(i0);
            const auto between = [&](auto& field) {
                return at(field, before, i0) + t * (at(field, before, i0 + 1) - at(field, before, i0));
            };
            const float ground_m = between(land.height_m);
            const float shade_m = between(top_m_);
            const bool is_nearer = ground_m >= shade_m;
            at(top_m_, line, i) = (is_nearer ? ground_m : shade_m) - fall_m;
            at(away_m_, line, i) = (is_nearer ? 0.0F : between(away_m_)) + step_m;
        }
    }
}

float LandShadow::sun_at(const glm::vec3& p) const {
    const float half = 0.5F * static_cast<float>(top_m_.columns - 1);
    const float column = p.x / cell_m_ + half;
    const float row = p.z / cell_m_ + half;
    const float edge_m = 0.35F + softness_ * mesh::sample(away_m_, column, row);
    const float t = std::clamp(0.5F + (p.y - mesh::sample(top_m_, column, row)) / (2.0F * edge_m), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

namespace {

// Light that the ground itself sends out, coarse and smooth: what fills the shade of hollows with the colour of their
// flanks.
class Bounce {
  public:
    Bounce(const scene::Land& land, float withered, const scene::Sky& sky, const LandShadow& shadow)
        : sent_(kSide, kSide), per_m_(static_cast<float>(kSide) / land.side_m()) {
        const float colour_seen = scene::colour_seen(sky.darkness);
        const glm::vec3 ambient = sky.ambient.on({0, 1, 0});
        for_rows(kSide, [&](int y) {
            for (int x = 0; x < kSide; ++x) {
                const glm::vec2 at{(static_cast<float>(x) + 0.5F) / per_m_ - 0.5F * land.side_m(),
                                   (static_cast<float>(y) + 0.5F) / per_m_ - 0.5F * land.side_m()};
                const float height_m = std::max(scene::ground_height_m(land, at), 0.0F);
                const float facing = std::max(glm::dot(scene::ground_normal(land, at), sky.sun_direction), 0.0F);
                const float sun = facing * shadow.sun_at({at.x, height_m + 0.1F, at.y});
                const glm::vec3 own = albedo(land, x, y);
                const glm::vec3 seen = scene::seen_by_night(own * scene::withering_of(own, withered), colour_seen);
                sent_.at(x, y) = seen * (ambient + sun * sky.sunlight) * sky.bounce;
            }
        });
    }
    glm::vec3 around(const glm::vec2& at) const {
        const float column = std::clamp(at.x * per_m_ + 0.5F * kSide - 0.5F, 0.0F, kSide - 1.001F);
        const float row = std::clamp(at.y * per_m_ + 0.5F * kSide - 0.5F, 0.0F, kSide - 1.001F);
        const int x = static_cast<int>(column);
        const int y = static_cast<int>(row);
        const float tx = column - static_cast<float>(x);
        return glm::mix(glm::mix(sent_.at(x, y), sent_.at(x + 1, y), tx),
                        glm::mix(sent_.at(x, y + 1), sent_.at(x + 1, y + 1), tx), row - static_cast<float>(y));
    }

  private:
    static constexpr int kSide = 48;

    static glm::vec3 albedo(const scene::Land& land, int x, int y) {
        if (land.albedo.is_empty()) return land.far_colour;
        const auto within = [](int i, int size) { return (2 * i + 1) * size / (2 * kSide); };
        const glm::vec3 p = land.albedo.colour(within(x, land.albedo.width()), within(y, land.albedo.height()));
        // Near enough to sRGB for a mean of nothing finer.
        const glm::vec3 c = p / 255.0F;
        return c * c;
    }
    mesh::Grid<glm::vec3> sent_;
    float per_m_;
};

struct Pixel {
    glm::vec2 at_m;
    float height_m;
    float sun;   // past crowns and stone, 0 to 1
    float open;  // of the sky, past land, crowns and stone, 0 to 1
    float bare;  // of the ground about it, what is not below the same crown, 0 to 1
};

glm::vec3 light_on(const Pixel& p, const scene::Land& land, const scene::Sky& sky, const LandShadow& shadow,
                   const Bounce& bounce) {
    // Under water it is the surface that takes the light.
    const glm::vec3 normal = p.height_m > 0 ? scene::ground_normal(land, p.at_m) : glm::vec3{0, 1, 0};
    const float facing = std::max(glm::dot(normal, sky.sun_direction), 0.0F);
    const float sun = facing * p.sun * shadow.sun_at({p.at_m.x, std::max(p.height_m, 0.0F) + 0.1F, p.at_m.y});
    return sun * sky.sunlight + p.open * sky.ambient.on(normal) +
           std::max(1.0F - p.open, 0.0F) * p.bare * bounce.around(p.at_m);
}

}  // namespace

scene::BakedLight bake_light(const scene::Land& land, const Openness& open, const scene::Sky& sky,
                             const scene::Flora& flora, std::span<const scene::Plant> plants, const LandShadow& shadow,
                             int side_px) {
    scene::BakedLight light{mesh::Image(side_px, side_px, 4)};
    const Bounce bounce(land, flora.cover.withered, sky, shadow);
    CrownShade crowns = cast_crowns(land, sky.sun_direction, flora, plants, side_px);
    darken(crowns.sun, cast_stone(land, sky.sun_direction, side_px), 0.94F);
    darken(crowns.sky, cast_stone(land, {0, 1, 0}, side_px), 0.6F);
    darken(crowns.sun, cast_houses(land, sky.sun_direction, side_px), 0.94F);
    darken(crowns.sky, cast_houses(land, {0, 1, 0}, side_px), 0.5F);
    const float px_m = land.side_m() / static_cast<float>(side_px);
    const float half_m = 0.5F * land.side_m();
    const float open_per_px = static_cast<float>(open.sky.columns) / static_cast<float>(side_px);
    for_rows(side_px, [&](int y) {
        for (int x = 0; x < side_px; ++x) {
            const glm::vec2 at{(static_cast<float>(x) + 0.5F) * px_m - half_m,
                               (static_cast<float>(y) + 0.5F) * px_m - half_m};
            const float column = (static_cast<float>(x) + 0.5F) * open_per_px - 0.5F;
            const float row = (static_cast<float>(y) + 0.5F) * open_per_px - 0.5F;
            const float seen = mesh::sample(open.sky, column, row) * crowns.sky.at(x, y);
            const float left = mesh::sample(open.folds, column, row) *
                               std::clamp(1.0F - sky.occlusion * (1.0F - seen), 0.25F * seen, 1.0F);
            const Pixel p{at, scene::ground_height_m(land, at), crowns.sun.at(x, y), left, crowns.sky.at(x, y)};
            const glm::vec3 c = light_on(p, land, sky, shadow, bounce);
            std::uint8_t* pixel = light.ground.pixel(x, y);
            pixel[0] = half_byte(c.x);
            pixel[1] = half_byte(c.y);
            pixel[2] = half_byte(c.z);
            pixel[3] =
                static_cast<std::uint8_t>(255.0F * std::clamp(scene::water_depth_m(land, at) / kDeepest_m, 0.0F, 1.0F));
        }
    });
    return light;
}

}  // namespace quadrat::synthesis
