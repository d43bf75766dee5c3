// SPDX-License-Identifier: Apache-2.0
#include "render/passes/houses.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr float kNear_px_per_m = 5.5F;  // from there on every pane is seen,
constexpr float kMiddle_px_per_m = 2.0F;
constexpr float kLeast_px = 0.7F;
constexpr float kUnitsPerM = 256;
constexpr float kBoundsWear = 0.7F;  // of walls, fences and hedges: nobody paints them

struct HouseLook {
    PackedNormal normal;
    std::uint8_t root_colour[3];
    std::uint8_t code;
    std::int16_t on_surface[2];
};

// A settlement's corners in the order they are sent: house by house, level by level, then what bounds the plots.
struct Corners {
    std::vector<glm::vec3> places;
    std::vector<HouseLook> looks;
};

std::int16_t units(float m) {
    return static_cast<std::int16_t>(std::lround(std::clamp(m * kUnitsPerM, -32000.0F, 32000.0F)));
}

bool is_roof(scene::Cladding cladding) {
    return cladding >= scene::Cladding::Tiles && cladding <= scene::Cladding::Thatch;
}

// A cladding and how worn it is in one byte, below those of lamps.
std::uint8_t code_of(scene::Cladding cladding, float wear) {
    const auto worn = static_cast<int>(std::lround(7 * std::clamp(wear, 0.0F, 1.0F)));
    return static_cast<std::uint8_t>(worn + 8 * static_cast<int>(cladding));
}

void append(Corners& to, const scene::Masses& masses, const scene::House& house, float wear) {
    const mesh::Mesh& mesh = masses.mesh;
    for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
        to.places.push_back(scene::placed(house, mesh.positions_m[i]));
        // A stack's bricks are laid as slates are, but stand upright.
        const bool is_slope = is_roof(masses.claddings[i]) && mesh.normals[i].y > 0.1F;
        const glm::vec3 tint = is_slope ? house.roof_tint : house.wall_tint;
        const glm::vec3 colour = glm::max(masses.colours[i] * tint, glm::vec3{0});
        const auto root = [&](int c) { return unsigned_byte(std::sqrt(colour[c])); };
        auto code = code_of(masses.claddings[i], wear);
        if (masses.lamps[i] > 0) {
            const float hour = masses.lamps[i] + house.evening;
            code = static_cast<std::uint8_t>(128 + std::lround(127 * (hour - std::floor(hour))));
        }
        to.looks.push_back({packed_normal(scene::turned(house, mesh.normals[i])),
                            {root(0), root(1), root(2)},
                            code,
                            {units(mesh.texcoords[i].x), units(mesh.texcoords[i].y)}});
    }
}

// Which houses have their finest level: as many as a viewer in the south could come near.
std::vector<bool> with_finest(const scene::Settlement& settlement) {
    constexpr glm::vec2 kViewer_m{0, 270};
    constexpr std::size_t kMost = 90;
    std::vector<std::size_t> order(settlement.houses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto away_m = [&](std::size_t i) {
        const glm::vec3& foot = settlement.houses[i].foot_m;
        return glm::distance(glm::vec2{foot.x, foot.z}, kViewer_m);
    };
    std::ranges::stable_sort(order, {}, away_m);
    std::vector<bool> has(order.size(), false);
    for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i) has[order[i]] = true;
    return has;
}

// visit(house, level, masses) of all that is sent, in order.
template <typename Visit>
void for_levels(const scene::Settlement& settlement, const Visit& visit) {
    const std::vector<bool> has_finest = with_finest(settlement);
    for (std::size_t i = 0; i < settlement.houses.size(); ++i) {
        const scene::House& house = settlement.houses[i];
        const auto& levels = settlement.buildings[house.building].levels;
        for (std::size_t level = has_finest[i] ? 0 : 1; level < levels.size(); ++level) visit(i, level, levels[level]);
    }
}

std::size_t corners_of(const scene::Settlement& settlement) {
    std::size_t sum = 0;
    for (const scene::Masses& piece : settlement.bounds) sum += piece.mesh.positions_m.size();
    for_levels(settlement,
               [&](std::size_t, std::size_t, const scene::Masses& masses) { sum += masses.mesh.positions_m.size(); });
    return sum;
}

}  // namespace

HouseLevels::HouseLevels(const scene::Settlement& settlement) {
    std::vector<std::size_t> first_list;
    for (const scene::Building& building : settlement.buildings) {
        first_list.push_back(indices_.size());
        for (const scene::Masses& level : building.levels) indices_.push_back(level.mesh.indices);
    }
    std::uint32_t corner = 0;
    for (const scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        standing_.push_back({house.foot_m + glm::vec3{0, 0.5F * building.height_m, 0},
                             glm::length(glm::vec3{building.half_m, 0.5F * building.height_m}) + 1,
                             {}});
    }
    for_levels(settlement, [&](std::size_t i, std::size_t level, const scene::Masses& masses) {
        Standing& standing = standing_[i];
        standing.finest = std::min(standing.finest, level);
        standing.levels.push_back({corner, first_list[settlement.houses[i].building] + level});
        corner += static_cast<std::uint32_t>(masses.mesh.positions_m.size());
    });
    for (const scene::Masses& piece : settlement.bounds) {
        const std::vector<glm::vec3>& places = piece.mesh.positions_m;
        glm::vec3 low = places.front();
        glm::vec3 high = low;
        for (const glm::vec3& p : places) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        standing_.push_back({0.5F * (low + high), 0.5F * glm::distance(low, high), {{corner, indices_.size()}}, 0});
        indices_.push_back(piece.mesh.indices);
        corner += static_cast<std::uint32_t>(places.size());
    }
}

void HouseLevels::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    const auto built = static_cast<std::size_t>(std::ceil(wish.standing * static_cast<float>(standing_.size())));
    for (const Standing& house : std::span(standing_).first(std::min(built, standing_.size()))) {
        const float distance_m = std::max(glm::distance(house.middle_m, wish.eye_m) - house.radius_m, 0.5F);
        const float px_per_m = wish.pixels_per_radian / distance_m;
        if (house.radius_m * px_per_m < kLeast_px) continue;
        if (!wish.reach.may_hold_sphere(house.middle_m, house.radius_m)) continue;
        if (!frustum.may_see_sphere(house.middle_m, house.radius_m)) continue;
        if (wish.horizon && wish.horizon->hides_standing({house.middle_m.x, house.middle_m.z}, house.radius_m,
                                                         house.middle_m.y + house.radius_m))
            continue;
        const float fine = px_per_m * wish.fineness;
        const std::size_t wished = fine > kNear_px_per_m ? 0 : fine > kMiddle_px_per_m ? 1 : 2;
        const std::size_t wanted = std::max(wished, house.finest) - house.finest;
        const Level& level = house.levels[std::min(wanted, house.levels.size() - 1)];
        for (const std::uint32_t index : indices_[level.list]) indices.push_back(level.first + index);
    }
}

void add_houses(gl::Slices& slices, HousesOnGpu& houses, const std::shared_ptr<const scene::Land>& land) {
    const scene::Settlement& settlement = land->settlement;
    const std::size_t count = corners_of(settlement);
    if (count == 0) return;
    const auto corners = std::make_shared<Corners>();
    slices.prepare([&houses, &settlement, land, corners, count] {
        houses.levels = HouseLevels(settlement);
        corners->places.reserve(count);
        corners->looks.reserve(count);
        for_levels(settlement, [&](std::size_t i, std::size_t, const scene::Masses& masses) {
            const scene::House& house = settlement.houses[i];
            append(*corners, masses, house, settlement.buildings[house.building].wear);
        });
        for (const scene::Masses& piece : settlement.bounds) append(*corners, piece, {}, kBoundsWear);
    });
    gl::add_elements<glm::vec3>(slices, houses.corners, GL_ARRAY_BUFFER, count,
                                [corners] { return std::span<const glm::vec3>(corners->places); });
    gl::add_elements<HouseLook>(slices, houses.looks, GL_ARRAY_BUFFER, count,
                                [corners] { return std::span<const HouseLook>(corners->looks); });
    const std::shared_ptr<const mesh::Image> stains =
        settlement.stains ? settlement.stains : std::make_shared<mesh::Image>(1, 1, 1);
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = stains->width;
    tiled.height = stains->height;
    tiled.channels = 1;
    gl::add_picture(slices, houses.stains, stains, tiled);
}

HousesPass::HousesPass()
    : program_("houses.vert", "houses.frag"),
      vertices_{{0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
                {1,
                 sizeof(HouseLook),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(HouseLook, root_colour)},
                  {6, 2, GL_SHORT, gl::Numbers::AsTheyAre, offsetof(HouseLook, on_surface)}}}} {}

gl::Work HousesPass::draw(const HousesOnGpu& houses, const gl::StreamBuffer& indices, const IndexRange& range) const {
    if (range.count == 0) return {};
    program_.use();
    houses.stains.bind(0);
    vertices_.bind();
    vertices_.feed(0, houses.corners.name());
    vertices_.feed(1, houses.looks.name());
    return draw_indices(vertices_, indices, range.first, range.count);
}

}  // namespace quadrat::render::passes
