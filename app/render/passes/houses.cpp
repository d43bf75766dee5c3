// SPDX-License-Identifier: Apache-2.0
#include "render/passes/houses.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

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

const scene::Masses& masses_of(const scene::Settlement& settlement, const choose::SentLevel& sent) {
    return settlement.buildings[settlement.houses[sent.house].building].levels[sent.level];
}

std::size_t corners_of(const scene::Settlement& settlement) {
    std::size_t sum = 0;
    for (const scene::Masses& piece : settlement.bounds) sum += piece.mesh.positions_m.size();
    for (const choose::SentLevel& sent : choose::sent_levels(settlement))
        sum += masses_of(settlement, sent).mesh.positions_m.size();
    return sum;
}

}  // namespace

void add_houses(gl::Slices& slices, HousesOnGpu& houses, const std::shared_ptr<const scene::Land>& land) {
    const scene::Settlement& settlement = land->settlement;
    const std::size_t count = corners_of(settlement);
    if (count == 0) return;
    const auto corners = std::make_shared<Corners>();
    slices.prepare([&houses, &settlement, land, corners, count] {
        houses.levels = choose::HouseLevels(settlement);
        corners->places.reserve(count);
        corners->looks.reserve(count);
        for (const choose::SentLevel& sent : choose::sent_levels(settlement)) {
            const scene::House& house = settlement.houses[sent.house];
            append(*corners, masses_of(settlement, sent), house, settlement.buildings[house.building].wear);
        }
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

gl::Work HousesPass::draw(const HousesOnGpu& houses, const gl::StreamBuffer& indices,
                          const choose::IndexRange& range) const {
    if (range.count == 0) return {};
    program_.use();
    houses.stains.bind(0);
    vertices_.bind();
    vertices_.feed(0, houses.corners.name());
    vertices_.feed(1, houses.looks.name());
    return draw_indices(vertices_, indices, range.first, range.count);
}

}  // namespace quadrat::render::passes
