// SPDX-License-Identifier: Apache-2.0
// Rock in steps, by example: Merrell's model synthesis (noise/model_synthesis) on a small example (tile_examples).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <string_view>

#include "scene/colour.hpp"
#include "synthesis/land/facets.hpp"
#include "synthesis/land/layered_ground.hpp"
#include "synthesis/land/tile_examples.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

const TileExample& example_named(std::string_view name) {
    return *std::ranges::find(tile_examples(), name, &TileExample::name);
}

struct LedgePlace {
    glm::vec2 at_m{0};
    glm::vec2 along{1, 0};  // the tiles' east
    float foot_m = 0;

    glm::vec2 at(float x, float z) const { return at_m + x * along + z * glm::vec2{-along.y, along.x}; }
};

// Ground as level as there is, dry, off the roads, near before the viewer; ground kept for a settlement that nobody has
// come to is best.
std::optional<LedgePlace> find_place(const scene::Land& land, const Stones& stones, float half_m, base::Seed seed) {
    std::optional<LedgePlace> best;
    float least = 1.0e6F;
    const bool has_site = land.site && land.settlement.is_empty();
    for (std::uint64_t i = 0; i < 240; ++i) {
        base::RandomStream random{seed.child(i)};
        LedgePlace place;
        const float far_m = random.between(45.0F, 230.0F);
        const float aside = random.between(-0.45F, 0.45F);
        place.at_m = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        if (has_site && i % 2 == 0)
            place.at_m = glm::vec2{land.site->middle_m.x, land.site->middle_m.z} +
                         0.3F * land.site->radius_m * glm::vec2{random.between(-1, 1), random.between(-1, 1)};
        const float turn = aside + random.between(0.2F, 1.2F);
        place.along = {std::cos(turn), std::sin(turn)};
        float lowest_m = 1.0e6F;
        float highest_m = -1.0e6F;
        bool is_dry = true;
        for (int k = 0; k < 9; ++k) {
            const glm::vec2 corner =
                place.at(half_m * static_cast<float>(k % 3 - 1), half_m * static_cast<float>(k / 3 - 1));
            const float ground_m = scene::ground_height_m(land, corner);
            lowest_m = std::min(lowest_m, ground_m);
            highest_m = std::max(highest_m, ground_m);
            is_dry = is_dry && ground_m > 0.5F && scene::water_depth_m(land, corner) <= 0;
        }
        const bool is_free = std::ranges::none_of(stones.landmarks, [&](const scene::Landmark& other) {
            return glm::length(glm::vec2{other.at_m.x, other.at_m.z} - place.at_m) < other.size_m + 1.5F * half_m;
        });
        if (!is_dry || !is_free) continue;
        if (!(has_site && i % 2 == 0) && scene::to_road_m(land, place.at_m) < half_m) continue;
        place.foot_m = lowest_m + 0.35F * (highest_m - lowest_m);
        const bool is_seen = is_in_sight(land, {place.at_m.x, highest_m + 3, place.at_m.y});
        const float price =
            (highest_m - lowest_m) / half_m + 0.004F * std::abs(far_m - 90.0F) + (is_seen ? 0.0F : 1.5F);
        if (price >= least || highest_m - lowest_m > 0.7F * half_m) continue;
        least = price;
        best = place;
    }
    return best;
}

// An uneven round: what lies outside of it has weathered away, for tiles end in a square.
class Weathered {
  public:
    explicit Weathered(base::Seed seed) {
        base::RandomStream random{seed};
        for (float& phase : phases_) phase = random.between(0, glm::two_pi<float>());
    }

    // Of a square from -1 to 1.
    bool holds(glm::vec2 at) const {
        const float turn = std::atan2(at.y, at.x);
        const float edge = 0.86F + 0.08F * std::sin(2 * turn + phases_[0]) + 0.06F * std::sin(3 * turn + phases_[1]) +
                           0.04F * std::sin(7 * turn + phases_[2]);
        return glm::length(at) < edge;
    }

  private:
    std::array<float, 3> phases_{};
};

void add_terraces(Stones& stones, const StoneGround& ground, const LedgePlace& place, const noise::Tiles& tiles,
                  const TileShape& shape, const Strata& strata, const Weathered& weathered) {
    constexpr int kCells = 3;  // of layered ground, to a tile
    LayeredGround layers(kCells * tiles.size.x, kCells * tiles.size.y, shape.side_m / kCells, -shape.sunk_m);
    const glm::vec2 middle = 0.5F * glm::vec2{layers.columns(), layers.rows()};
    for (int y = 0; y < layers.rows(); ++y)
        for (int x = 0; x < layers.columns(); ++x) {
            if (!weathered.holds((glm::vec2{x, y} + 0.5F) / middle - 1.0F)) continue;
            layers.fill(x, y, -shape.sunk_m, 0, Material::Rock);
            for (int z = 0; z < tiles.size.z; ++z) {
                const char tile = tiles.at({x / kCells, y / kCells, z});
                const float from_m = shape.storey_m * static_cast<float>(z);
                if (tile == 's') layers.fill(x, y, from_m, from_m + 0.5F * shape.storey_m, Material::Sand);
                if (tile == '#' || tile == 't') layers.fill(x, y, from_m, from_m + shape.storey_m, Material::Rock);
            }
        }
    layers.settle(0.7F, 8);
    const mesh::Surface surface = layers.surface();
    const std::size_t first = stones.stone.mesh.positions_m.size();
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
        std::array<glm::vec3, 3> at{};
        std::array<glm::vec3, 3> colours{};
        bool is_under = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& own = surface.positions[surface.indices[i + c]];
            const glm::vec2 level = place.at(own.x, own.z);
            const float ground_m = scene::ground_height_m(ground.land, level);
            const float low = 1 - glm::smoothstep(0.1F, 1.0F, own.y / shape.storey_m);
            at[c] = {level.x, place.foot_m + own.y + low * (ground_m - place.foot_m - 0.5F), level.y};
            is_under = is_under && at[c].y < ground_m - 0.3F;
        }
        for (std::size_t c = 0; c < 3; ++c) colours[c] = 1.25F * strata.at(at[c].y, 0.15F);
        if (!is_under) add_facet(stones.stone, at, colours);
    }
    // Its cells are square: weathered, they are not seen.
    round_off(stones.stone, first, 0.8F);
    // Ledges are overgrown.
    const glm::vec3 turf = scene::mix_colours(ground.palette.lush, ground.palette.dry, 0.4F);
    for (std::size_t i = first; i < stones.stone.colours.size(); ++i) {
        const float green = 0.8F * glm::smoothstep(0.74F, 0.97F, stones.stone.mesh.normals[i].y);
        stones.stone.colours[i] = scene::mix_colours(stones.stone.colours[i], turf, green);
    }
}

}  // namespace

void add_rock_ledges(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                     base::Seed seed) {
    const TileExample& of = example_named("terraces");
    TileShape shape{3.0F, p.ledge_kind < 0.5F ? 1.5F : 2.6F, 3.0F};
    const int side = std::clamp(static_cast<int>(std::lround(p.ledge_size_m / shape.side_m)), 8, 14);
    shape.side_m = p.ledge_size_m / static_cast<float>(side);
    const auto place = find_place(ground.land, stones, 0.5F * p.ledge_size_m, seed.child("place"));
    if (!place) return;
    const int storeys = p.ledge_decay < 0.4F ? 4 : p.ledge_decay < 0.8F ? 3 : 2;
    const noise::Tiles tiles =
        noise::synthesise(noise::tiles_from(of.text, std::string(of.name)), {side, side - side / 4, storeys},
                          weights_of(of, p.ledge_decay), seed.child("tiles"));
    add_terraces(stones, ground, *place, tiles, shape, strata, Weathered{seed.child("edge")});
    const glm::vec2 to_viewer = glm::normalize(kViewer_m - place->at_m);
    stones.landmarks.push_back(
        {{place->at_m.x, place->foot_m + shape.storey_m, place->at_m.y}, to_viewer, p.ledge_size_m});
    stones.footprints.push_back({place->at_m, 0.35F * p.ledge_size_m});
    stones.forecourts.push_back({place->at_m, 0.6F * p.ledge_size_m});
}

}  // namespace quadrat::synthesis::land
