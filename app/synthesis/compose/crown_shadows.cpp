// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/crown_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "scene/scene.hpp"

namespace quadrat::synthesis {
namespace {

struct Ellipse {
    glm::vec2 middle_m;
    glm::vec2 along;  // unit, of the longer axis
    float long_m;
    float wide_m;
    float darkness;  // at its middle
};

// What is narrower than light can show is wider and fainter, and darkens as much in all.
Ellipse shown(Ellipse e, float least_m) {
    const float area = e.long_m * e.wide_m;
    e.long_m = std::max(e.long_m, least_m);
    e.wide_m = std::max(e.wide_m, least_m);
    e.darkness *= area / (e.long_m * e.wide_m);
    return e;
}

void darken(mesh::Field& field, float px_m, float half_m, const Ellipse& e) {
    const float reach = std::max(e.long_m, e.wide_m) + px_m;
    const auto px = [&](float m) { return static_cast<int>(std::floor((m + half_m) / px_m)); };
    const int x0 = std::max(px(e.middle_m.x - reach), 0);
    const int x1 = std::min(px(e.middle_m.x + reach), field.columns - 1);
    const int y0 = std::max(px(e.middle_m.y - reach), 0);
    const int y1 = std::min(px(e.middle_m.y + reach), field.rows - 1);
    const glm::vec2 across{-e.along.y, e.along.x};
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const glm::vec2 at{(static_cast<float>(x) + 0.5F) * px_m - half_m,
                               (static_cast<float>(y) + 0.5F) * px_m - half_m};
            const float u = glm::dot(at - e.middle_m, e.along) / e.long_m;
            const float v = glm::dot(at - e.middle_m, across) / e.wide_m;
            const float r = u * u + v * v;
            if (r >= 1) continue;
            const float inside = 1.0F - r;
            field.at(x, y) *= 1.0F - e.darkness * std::min(1.0F, 1.8F * inside);
        }
    }
}

// The share of light from above that its crown takes: leaves lie in it by chance (Beer & Lambert), and half of each
// faces that way. A bare tree takes little.
float taken_by(const scene::Species& species) {
    const float crown_m2 = std::numbers::pi_v<float> * species.crown_radius_m * species.crown_radius_m;
    return 1 - 0.85F * std::exp(-0.9F * scene::area_m2(species.leaves) / std::max(crown_m2, 0.01F));
}

}  // namespace

CrownShade cast_crowns(const scene::Land& land, const glm::vec3& sun_direction, const scene::Flora& flora,
                       std::span<const scene::Plant> plants, int side) {
    CrownShade shade{mesh::Field(side, side, 1.0F), mesh::Field(side, side, 1.0F)};
    const float half_m = 0.5F * land.side_m();
    const float px_m = land.side_m() / static_cast<float>(side);
    // In coarser light than the standard one the same shadows fall, as well as it can show them.
    const float fine_m = std::min(px_m, land.side_m() / static_cast<float>(scene::Fineness{}.light_px));
    const float least_m = 0.75F * px_m;
    const glm::vec2 flat{sun_direction.x, sun_direction.z};
    const float flat_length = std::max(glm::length(flat), 1.0e-3F);
    const glm::vec2 away = -flat / flat_length;
    const float run_per_rise = std::min(flat_length / std::max(sun_direction.y, 0.02F), 9.0F);
    std::vector<float> taken;
    for (const scene::Species& species : flora.species)
        taken.push_back(species.storey == scene::Storey::Herb ? 0 : taken_by(species));
    for (const scene::Plant& plant : plants) {
        const scene::Species& species = flora.species[plant.species];
        if (species.storey == scene::Storey::Herb) continue;
        const float share = taken[plant.species];
        const float radius_m = std::max(species.crown_radius_m * plant.scale, 0.75F * fine_m);
        const float high_m = species.height_m * plant.scale;
        const float crown_m = 0.58F * high_m;
        const glm::vec2 root{plant.root_m.x, plant.root_m.z};
        // Where the shadow of the crown's middle meets the ground, which may rise or fall on the way: from where it
        // would meet level ground.
        glm::vec2 spot = root + away * (run_per_rise * crown_m);
        for (int i = 0; i < 4; ++i) {
            const float drop_m = std::max(plant.root_m.y + crown_m - scene::ground_height_m(land, spot), 0.0F);
            spot = root + away * (0.5F * glm::length(spot - root) + 0.5F * run_per_rise * drop_m);
        }
        const float tall_m = 0.40F * high_m * run_per_rise;
        darken(shade.sun, px_m, half_m,
               shown({spot, away, std::hypot(radius_m, tall_m), radius_m, 0.80F * std::max(share, 0.5F)}, least_m));
        // The stem's shadow ties the crown's to the root.
        const float stem_m = 0.5F * glm::length(spot - root);
        if (stem_m > fine_m)
            darken(shade.sun, px_m, half_m,
                   shown({0.5F * (root + spot), away, stem_m, std::max(0.22F * radius_m, fine_m), 0.5F}, least_m));
        darken(shade.sky, px_m, half_m,
               shown({root, {1, 0}, 1.15F * radius_m, 1.15F * radius_m, 0.60F * share}, least_m));
    }
    return shade;
}

}  // namespace quadrat::synthesis
