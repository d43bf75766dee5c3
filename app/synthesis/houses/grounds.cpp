// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/grounds.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr int kFewRows = 24;
const glm::vec3 kEarth{0.53F, 0.46F, 0.35F};  // sRGB
const glm::vec3 kDug{0.36F, 0.28F, 0.20F};
const glm::vec3 kBalk{0.36F, 0.45F, 0.24F};  // the grass between fields

void blend(std::uint8_t* pixel, const glm::vec3& srgb, float share) {
    for (int c = 0; c < 3; ++c) {
        const auto from = static_cast<float>(pixel[c]);
        pixel[c] = static_cast<std::uint8_t>(glm::clamp(from + share * (255 * srgb[c] - from), 0.0F, 255.0F) + 0.5F);
    }
}

// The picture, and which of its pixels lie about a place.
class Canvas {
  public:
    Canvas(mesh::Image& albedo, float side_m)
        : albedo_(albedo),
          per_m_(static_cast<float>(albedo.width) / side_m),
          half_(0.5F * static_cast<float>(albedo.width)) {}

    template <typename Paint>
    void paint(glm::vec2 low_m, glm::vec2 high_m, const Paint& paint_at) const {
        const int first = pixel_of(low_m.y);
        const int last = pixel_of(high_m.y);
        const auto row = [&](int y) {
            for (int x = pixel_of(low_m.x); x <= pixel_of(high_m.x); ++x) {
                const glm::vec2 at = (glm::vec2{static_cast<float>(x), static_cast<float>(y)} + 0.5F - half_) / per_m_;
                paint_at(albedo_.pixel(x, y), at, x, y);
            }
        };
        // Rows are nobody else's, so that threads do not matter; a few are not worth waking anybody.
        if (last - first < kFewRows)
            for (int y = first; y <= last; ++y) row(y);
        else
            oneapi::tbb::parallel_for(first, last + 1, row);
    }

  private:
    int pixel_of(float m) const { return std::clamp(static_cast<int>(m * per_m_ + half_), 0, albedo_.width - 1); }
    mesh::Image& albedo_;
    float per_m_, half_;
};

// Snow lies where it was painted, on a field as about it: its rows show faintly.
float bare_of_snow(const scene::Land& land, glm::vec2 at_m, const std::uint8_t* pixel) {
    if (scene::ground_height_m(land, at_m) <= land.snow_line_m) return 1;
    return 1 - 0.88F * glm::smoothstep(124.0F, 173.0F, static_cast<float>(std::min({pixel[0], pixel[1], pixel[2]})));
}

void paint_field(const Canvas& canvas, const scene::Land& land, const scene::FieldPlot& field, base::Seed seed) {
    const auto [low, high] = extent_of(field.outline_m);
    const glm::vec2 across{-field.along.y, field.along.x};
    const Inside inside(field.outline_m);
    canvas.paint(low, high, [&](std::uint8_t* pixel, glm::vec2 at, int x, int y) {
        const float in = inside.by_m(at);
        if (in < 0) return;
        const float chance = base::unit_of(base::hash_of(seed, x, y));
        const float row = field.rows > 0 ? std::sin(glm::dot(at, across) * 1.6F) : 0.0F;
        const float tone = 1 + 0.09F * (chance - 0.5F) + 0.13F * field.rows * row;
        const float edge = glm::smoothstep(0.3F, 1.9F, in + 0.5F * chance);
        const float bare = bare_of_snow(land, at, pixel);
        if (edge < 1) blend(pixel, kBalk, 0.55F * (1 - edge) * bare);
        blend(pixel, field.colour * tone, 0.82F * edge * bare);
    });
}

void paint_yard(const Canvas& canvas, const scene::Land& land, const scene::Building& building,
                const scene::House& house, float green, base::Seed seed) {
    const glm::vec2 at_m{house.foot_m.x, house.foot_m.z};
    const float reach_m = glm::length(building.half_m) + 14;
    const scene::HouseFrame frame(building, house);
    const glm::vec3 lawn{0.43F, 0.52F, 0.27F};
    canvas.paint(at_m - reach_m, at_m + reach_m, [&](std::uint8_t* pixel, glm::vec2 at, int x, int y) {
        const float away_m = frame.away_m(at);
        if (away_m > 12 || (away_m > 3.7F && green <= 0)) return;
        const float ragged = base::unit_of(base::hash_of(seed, x, y));
        const float garden = 0.55F * green * (1 - glm::smoothstep(6.0F, 12.0F, away_m + 3 * ragged));
        if (garden > 0) blend(pixel, lawn * (0.93F + 0.14F * ragged), garden * bare_of_snow(land, at, pixel));
        const float worn = 0.8F * (1 - glm::smoothstep(0.4F, 2.2F + 1.4F * ragged, away_m));
        if (worn > 0) blend(pixel, kEarth * (0.9F + 0.15F * ragged), worn);
    });
}

// Dug earth under what is planted in it.
void paint_bed(const Canvas& canvas, const scene::GardenPlant& plant, base::Seed seed) {
    if (plant.what == scene::Bedded::FruitTree) return;
    const float reach_m = plant.what == scene::Bedded::Vegetable ? 0.6F : 0.5F;
    canvas.paint(plant.at_m - reach_m, plant.at_m + reach_m, [&](std::uint8_t* pixel, glm::vec2 at, int x, int y) {
        const float share = 1 - glm::smoothstep(0.3F * reach_m, reach_m, glm::distance(at, plant.at_m));
        const float chance = base::unit_of(base::hash_of(seed, x, y));
        if (share > 0) blend(pixel, kDug * (0.9F + 0.2F * chance), 0.75F * share);
    });
}

}  // namespace

void paint_grounds(mesh::Image& albedo, const scene::Land& land, const Settled& settled,
                   const std::vector<scene::FieldPlot>& fields, float green, base::Seed seed) {
    const Canvas canvas(albedo, land.side_m());
    for (const scene::FieldPlot& field : fields) paint_field(canvas, land, field, seed);
    const scene::Settlement& settlement = settled.settlement;
    for (const scene::House& house : settlement.houses)
        paint_yard(canvas, land, settlement.buildings[house.building], house, green, seed);
    for (const scene::GardenPlant& plant : land.settlement.gardens) paint_bed(canvas, plant, seed.child("beds"));
    for (const Lane& lane : settled.lanes)
        for (std::size_t i = 0; i + 1 < lane.line_m.size(); ++i) {
            const glm::vec2 a = lane.line_m[i];
            const glm::vec2 d = lane.line_m[i + 1] - a;
            const float reach_m = 0.5F * lane.width_m + 2;
            canvas.paint(glm::min(a, a + d) - reach_m, glm::max(a, a + d) + reach_m,
                         [&](std::uint8_t* pixel, glm::vec2 at, int x, int y) {
                             const float t = std::clamp(glm::dot(at - a, d) / glm::dot(d, d), 0.0F, 1.0F);
                             const float ragged = base::unit_of(base::hash_of(seed, x, y));
                             const float away_m = glm::distance(at, a + t * d) - 0.5F * lane.width_m;
                             const float share = 0.6F * (1 - glm::smoothstep(-0.4F, 1.2F, away_m + 0.5F * ragged));
                             if (share > 0) blend(pixel, kEarth * (0.92F + 0.16F * ragged), share);
                         });
        }
}

}  // namespace quadrat::synthesis::houses
