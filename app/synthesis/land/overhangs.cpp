// SPDX-License-Identifier: Apache-2.0
// Ground in layers (Peytavie et al. 2009), weathered by what its beds are made of: soft ones go back behind hard ones
// from every side, as in Beardall et al., "Goblins by spheroidal weathering", 2007, where corners go first.
#include "synthesis/land/overhangs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "scene/land_parameters.hpp"
#include "synthesis/land/facets.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kSunk_m = 3;      // how deep it reaches into the ground
constexpr float kRepose = 0.67F;  // rise over run of dry sand
constexpr int kAcross = 36;       // cells of its length
constexpr int kDeep = 24;         // and of its breadth
constexpr int kLevels = 40;       // of its height

// 0 hard to 1 soft, by height over the ground: the foot is soft, the cap hard.
float softness(float up_m, const OverhangShape& shape, noise::Key beds) {
    const float at = up_m / shape.bed_m;
    const float bed = std::floor(at);
    const float in = at - bed;
    const float chance = 0.5F + 1.5F * noise::gradient(beds, 0.73F * bed + 0.31F, 0.5F);
    const float own = static_cast<int>(bed) % 2 == 0 ? 0.75F : 0.15F;
    const float rounded = 1 - std::pow(std::abs(2 * in - 1), 3.0F);
    const float cap = 1 - glm::smoothstep(0.74F, 0.82F, up_m / shape.height_m);
    return cap * rounded * std::clamp(0.7F * own + 0.5F * chance, 0.0F, 1.0F);
}

struct Fin {
    glm::vec2 half_m;
    noise::Key outline;
    noise::Key along;

    // How far a place lies inside the outline, metres; less than 0: outside.
    float depth_m(glm::vec2 at_m) const {
        const glm::vec2 p = at_m / half_m;
        const float r = std::pow(std::pow(std::abs(p.x), 2.6F) + std::pow(std::abs(p.y), 2.6F), 1.0F / 2.6F);
        const float lump = noise::fbm(outline, at_m.x / half_m.y, at_m.y / half_m.y, {.count = 3, .gain = 0.45F});
        return half_m.y * (1 - r + 0.42F * lump);
    }
    // Here the weather reaches farther, there less; the pillars between are what bears the rest.
    float reach(glm::vec2 at_m) const {
        return std::clamp(0.75F + 1.5F * noise::gradient(along, 0.8F * at_m.x / half_m.y + 0.37F, 0.6F), 0.1F, 1.5F);
    }
};

void build(LayeredGround& ground, const Fin& fin, const OverhangShape& shape, noise::Key beds) {
    const float step_m = shape.height_m / kLevels;
    const glm::vec2 middle = 0.5F * glm::vec2{static_cast<float>(kAcross - 1), static_cast<float>(kDeep - 1)};
    for (int y = 0; y < kDeep; ++y) {
        for (int x = 0; x < kAcross; ++x) {
            const glm::vec2 at_m = ground.cell_m() * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - middle);
            const float depth_m = fin.depth_m(at_m);
            // No farther about it than sand runs.
            if (depth_m > -3 * ground.cell_m()) ground.fill(x, y, -kSunk_m, 0, Material::Rock);
            if (depth_m <= 0) continue;
            // The top is level in the middle and falls off toward the rim.
            const float top_m = shape.height_m * (0.72F + 0.28F * glm::smoothstep(0.0F, 0.6F * fin.half_m.y, depth_m)) *
                                (0.93F + 0.25F * noise::gradient(fin.along, 1.7F * at_m.x / fin.half_m.y, 4.4F));
            float fallen_m = 0;
            for (int level = 0; level < kLevels; ++level) {
                const float from_m = step_m * static_cast<float>(level);
                const float to_m = std::min(from_m + step_m, top_m);
                if (to_m <= from_m) break;
                const float recess_m =
                    shape.recess * fin.half_m.y * fin.reach(at_m) * softness(from_m + 0.5F * step_m, shape, beds);
                if (depth_m > recess_m)
                    ground.fill(x, y, from_m, to_m, Material::Rock);
                else
                    fallen_m += to_m - from_m;
            }
            // It comes down where it stood, and loosely.
            const float left_m = 0.25F * shape.sand * fallen_m;
            const float floor_m = std::max(ground.floor_m(x, y, 0.01F), 0.0F);
            ground.fill(x, y, floor_m, std::min(floor_m + left_m, ground.ceiling_m(x, y, floor_m)), Material::Sand);
        }
    }
}

}  // namespace

LayeredGround weathered_fin(const OverhangShape& shape, base::Seed seed) {
    base::RandomStream random{seed};
    const float half_length_m = shape.height_m * random.between(0.95F, 1.25F);
    const float cell_m = 2.5F * half_length_m / kAcross;
    const Fin fin{{half_length_m, shape.height_m * random.between(0.42F, 0.6F)},
                  noise::Key(seed.child("outline")),
                  noise::Key(seed.child("along"))};
    LayeredGround ground(kAcross, kDeep, cell_m, -kSunk_m);
    build(ground, fin, shape, noise::Key(seed.child("beds")));
    ground.drop_loose_rock_m3(0.5F * shape.height_m / kLevels);
    ground.settle(kRepose, 24);
    return ground;
}

namespace {

struct FinPlace {
    glm::vec2 at_m{0};
    glm::vec2 along{1, 0};  // its length's way
    float height_m = 12;
    float foot_m = 0;

    glm::vec2 at(float x, float z) const { return at_m + x * along + z * glm::vec2{-along.y, along.x}; }
};

// Dry and nearly level, near before the viewer, and seen.
std::optional<FinPlace> find_place(const scene::Land& land, const scene::LandParameters& p,
                                   const std::vector<scene::Landmark>& taken, base::Seed seed) {
    std::optional<FinPlace> best;
    float most = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        base::RandomStream random{seed.child(i)};
        const float far_m = random.between(80.0F, 280.0F);
        const float aside = random.between(-0.5F, 0.5F);
        FinPlace place;
        place.at_m = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        const float turn = aside + random.between(-0.6F, 0.6F);
        place.along = {std::cos(turn), std::sin(turn)};
        place.height_m = p.arch_height_m * random.between(0.8F, 1.0F);
        float lowest_m = 1.0e6F;
        float highest_m = -1.0e6F;
        bool is_right = std::max(std::abs(place.at_m.x), std::abs(place.at_m.y)) < 420.0F;
        for (int k = 0; k < 9 && is_right; ++k) {
            const glm::vec2 corner = place.at(1.1F * place.height_m * static_cast<float>(k % 3 - 1),
                                              0.6F * place.height_m * static_cast<float>(k / 3 - 1));
            const float ground_m = scene::ground_height_m(land, corner);
            lowest_m = std::min(lowest_m, ground_m);
            highest_m = std::max(highest_m, ground_m);
            is_right = scene::water_depth_m(land, corner) <= 0 && ground_m > 0.4F && scene::to_road_m(land, corner) > 1;
        }
        if (!is_right || highest_m - lowest_m > 0.45F * place.height_m) continue;
        for (const scene::Landmark& other : taken)
            is_right = is_right && glm::length(glm::vec2{other.at_m.x, other.at_m.z} - place.at_m) >
                                       1.5F * place.height_m + other.size_m;
        if (!is_right) continue;
        place.foot_m = scene::ground_height_m(land, place.at_m);
        const bool is_seen = is_in_sight(land, {place.at_m.x, place.foot_m + 0.6F * place.height_m, place.at_m.y});
        const float score = 1.2F - (highest_m - lowest_m) / place.height_m - 0.003F * std::abs(far_m - 110.0F) +
                            (is_seen ? 1.0F : 0.0F) + 0.3F * random.unit_f();
        if (score <= most) continue;
        most = score;
        best = place;
    }
    return best;
}

void build_fin(Stones& stones, const StoneGround& ground, const FinPlace& place, const scene::LandParameters& p,
               const Strata& strata, base::Seed seed) {
    const LayeredGround fin =
        weathered_fin({.height_m = place.height_m,
                       .recess = base::RandomStream{seed.child("recess")}.between(0.4F, 0.85F),
                       .bed_m = std::clamp(0.22F * p.ground_strata_m, 1.6F, 0.3F * place.height_m),
                       .sand = 0.5F},
                      seed);
    const mesh::Surface surface = fin.surface();
    const std::size_t first = stones.stone.mesh.positions_m.size();
    const auto placed = [&](const glm::vec3& at) {
        const glm::vec2 level = place.at(at.x, at.z);
        // What is level under it follows the ground, and so does the sand; the rock stands upright.
        const float slope_m = scene::ground_height_m(ground.land, level) - place.foot_m;
        const float low = 1 - glm::smoothstep(0.15F, 0.4F, at.y / place.height_m);
        return glm::vec3{level.x, place.foot_m + at.y + low * slope_m - 0.35F, level.y};
    };
    const glm::vec2 middle =
        0.5F * glm::vec2{static_cast<float>(fin.columns() - 1), static_cast<float>(fin.rows() - 1)};
    const auto colour = [&](const glm::vec3& own, const glm::vec3& at) {
        const int x = std::clamp(static_cast<int>(std::lround(own.x / fin.cell_m() + middle.x)), 0, fin.columns() - 1);
        const int y = std::clamp(static_cast<int>(std::lround(own.z / fin.cell_m() + middle.y)), 0, fin.rows() - 1);
        const bool is_sand = fin.at(x, y, own.y - 0.4F * fin.cell_m()) == Material::Sand;
        // Under a ceiling little light comes.
        const float ceiling_m = fin.ceiling_m(x, y, own.y + fin.cell_m());
        const float shade = ceiling_m < 1.0e5F ? 0.55F : 1.0F;
        return shade * (is_sand ? ground.palette.sand : strata.at(at.y, 0.15F));
    };
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
        std::array<glm::vec3, 3> at{};
        std::array<glm::vec3, 3> colours{};
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& own = surface.positions[surface.indices[i + c]];
            at[c] = placed(own);
            colours[c] = colour(own, at[c]);
        }
        add_facet(stones.stone, at, colours);
    }
    round_off(stones.stone, first, 0.6F);
    const glm::vec2 through{-place.along.y, place.along.x};
    const float toward = glm::dot(through, kViewer_m - place.at_m) < 0 ? -1.0F : 1.0F;
    stones.landmarks.push_back(
        {{place.at_m.x, place.foot_m + 0.5F * place.height_m, place.at_m.y}, toward * through, 2 * place.height_m});
    stones.footprints.push_back({place.at_m, 1.1F * place.height_m});
    stones.forecourts.push_back({place.at_m, 1.25F * place.height_m});
}

}  // namespace

void add_fin(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
             base::Seed seed) {
    const auto place = find_place(ground.land, p, stones.landmarks, seed);
    if (place) build_fin(stones, ground, *place, p, strata, seed);
}

}  // namespace quadrat::synthesis::land
