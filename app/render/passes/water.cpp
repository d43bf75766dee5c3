// SPDX-License-Identifier: Apache-2.0
#include "render/passes/water.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "base/seed.hpp"
#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/packing.hpp"
#include "render/passes/ranges.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSectors = 64;  // what is mirrored is worked out at their corners
constexpr int kRippleSide = 512;
constexpr int kWaves = 56;

std::vector<float> ring_radii_m() {
    std::vector<float> radii_m{0, 1.5F, 3};
    while (radii_m.back() < 9000) radii_m.push_back(1.22F * radii_m.back());
    radii_m.push_back(11500);
    return radii_m;
}

// Of a sector, the rings that a part of the landscape may hold.
choose::Range rings_within(const choose::Reach& reach) {
    constexpr std::size_t kIndicesARing = 6;
    const std::vector<float> radii_m = ring_radii_m();
    choose::Range rings;
    for (std::size_t ring = 0; ring + 1 < radii_m.size(); ++ring) {
        if (!reach.may_hold(radii_m[ring], radii_m[ring + 1])) continue;
        if (rings.count == 0) rings.first = ring * kIndicesARing;
        rings.count += kIndicesARing;
    }
    return rings;
}

std::vector<glm::vec2> ring_vertices() {
    std::vector<glm::vec2> vertices;
    for (const float radius_m : ring_radii_m()) {
        for (int sector = 0; sector < kSectors; ++sector) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(sector) / kSectors;
            vertices.emplace_back(radius_m * std::cos(turn), radius_m * std::sin(turn));
        }
    }
    return vertices;
}

std::vector<std::uint16_t> ring_indices() {
    std::vector<std::uint16_t> indices;
    const int rings = static_cast<int>(ring_radii_m().size());
    for (int sector = 0; sector < kSectors; ++sector) {
        for (int ring = 0; ring + 1 < rings; ++ring) {
            const int next = (sector + 1) % kSectors;
            const int inner = ring * kSectors;
            const int outer = inner + kSectors;
            // Counter-clockwise from above, where z points down the page.
            for (const int i :
                 {inner + sector, inner + next, outer + sector, inner + next, outer + next, outer + sector})
                indices.push_back(static_cast<std::uint16_t>(i));
        }
    }
    return indices;
}

// Slopes of a sum of sine waves that each fit the tile a whole number of times: it tiles without a seam.
struct Wave {
    glm::vec2 turns;  // across and down the tile, which repeats eleven times over the land
    float phase;
    float steepness;
};

using Waves = std::array<Wave, kWaves>;

Waves ripple_waves() {
    Waves all{};
    for (std::uint64_t i = 0; i < kWaves; ++i) {
        base::RandomStream stream{base::Seed{0x52'69'70'70'6c'65}.child(i)};
        // Of half a metre to four: a few longer ones would show as the tile's own lattice.
        const float length = 24.0F + 176.0F * stream.unit_f();
        const float bearing = 0.5F + 0.75F * stream.normal();
        all[i].turns = {1 + std::round(length * std::cos(bearing)), std::round(length * std::sin(bearing))};
        all[i].phase = 6.2832F * stream.unit_f();
        all[i].steepness = 1.6F / std::sqrt(std::max(glm::length(all[i].turns), 1.0F));
    }
    return all;
}

// cos and sin of turns * x + phase for every x along the tile.
std::vector<glm::vec2> turned_along(float turns, float phase) {
    std::vector<glm::vec2> along(kRippleSide);
    for (std::size_t x = 0; x < along.size(); ++x) {
        const float turn = turns * static_cast<float>(x) * (2 * std::numbers::pi_v<float> / kRippleSide) + phase;
        along[x] = {std::cos(turn), std::sin(turn)};
    }
    return along;
}

// Where the wind comes down on the water: streaks along it, many times as long as ripples, and within them finer ones.
Waves gust_waves() {
    constexpr float kLongest = 6;  // turns over the tile, which is the land's
    constexpr float kShortest = 180;
    Waves all{};
    for (std::uint64_t i = 0; i < kWaves; ++i) {
        base::RandomStream stream{base::Seed{0x67'75'73'74}.child(i)};
        const float turns = kLongest * std::pow(kShortest / kLongest, stream.unit_f());
        // Across the wind they change sooner than along it.
        const float bearing = 2.0F + 0.55F * stream.normal();
        all[i].turns = {std::round(turns * std::cos(bearing)), 1 + std::round(turns * std::sin(bearing))};
        all[i].phase = 6.2832F * stream.unit_f();
        all[i].steepness = 0.8F / std::pow(std::max(glm::length(all[i].turns), 1.0F), 0.35F);
    }
    return all;
}

// By rows.
std::vector<float> slopes_of(const Waves& waves) {
    std::vector<float> sums(static_cast<std::size_t>(kRippleSide) * kRippleSide);
    for (const Wave& wave : waves) {
        const auto across = turned_along(wave.turns.x, wave.phase);
        const auto down = turned_along(wave.turns.y, 0);
        for (std::size_t y = 0; y < down.size(); ++y) {
            float* row = &sums[y * kRippleSide];
            const glm::vec2 d = down[y] * wave.steepness;
            for (std::size_t x = 0; x < across.size(); ++x) row[x] += across[x].x * d.x - across[x].y * d.y;
        }
    }
    return sums;
}

mesh::Image ripples_and_gusts() {
    const std::vector<float> ripples = slopes_of(ripple_waves());
    const std::vector<float> gusts = slopes_of(gust_waves());
    mesh::Image image(kRippleSide, kRippleSide, 2);
    for (std::size_t i = 0; i < ripples.size(); ++i) {
        image.bytes[2 * i] = unsigned_byte(0.5F + 0.15F * ripples[i]);
        image.bytes[2 * i + 1] = unsigned_byte(0.5F + 0.225F * gusts[i]);
    }
    return image;
}

struct FreshCorner {
    glm::vec3 at_m;
    float foam;
    glm::vec2 current_m_s;
};

// What water.frag is told: a little foam at the banks of what runs, all over where it falls.
float foam_of(glm::vec2 current_m_s) {
    const float speed_m_s = glm::length(current_m_s);
    return 0.12F + 1.9F * std::clamp((speed_m_s - 2.4F) / 3.0F, 0.0F, 1.0F);
}

}  // namespace

void add_fresh_water(gl::Slices& slices, FreshWaterOnGpu& water, const std::shared_ptr<gl::BufferPool>& pool,
                     const std::shared_ptr<const scene::Land>& land) {
    const mesh::Mesh& mesh = land->fresh_water;
    if (mesh.indices.empty()) return;
    const auto corners = std::make_shared<std::vector<FreshCorner>>();
    const auto indices = std::make_shared<std::vector<std::uint32_t>>();
    // How many of the banks are taken is known when the levels are: room is made for all.
    const std::size_t most = mesh.positions_m.size() + choose::WaterLevels::most_banks(mesh);
    slices.prepare([&water, land, corners, indices, most] {
        water.levels = choose::WaterLevels(land->fresh_water, land->height_m, land->cell_m);
        *indices = water.levels.take_indices();
        const mesh::Mesh& surface = land->fresh_water;
        const auto add = [&](glm::vec3 at_m, glm::vec2 current_m_s) {
            corners->push_back({at_m, foam_of(current_m_s), current_m_s});
        };
        corners->reserve(most);
        for (std::size_t i = 0; i < surface.positions_m.size(); ++i) add(surface.positions_m[i], surface.texcoords[i]);
        for (const choose::WaterLevels::Bank& bank : water.levels.take_banks())
            add(bank.at_m, surface.texcoords[bank.like]);
        corners->resize(most);
    });
    gl::add_elements<FreshCorner>(slices, water.corners, pool, GL_ARRAY_BUFFER, most,
                                  [corners] { return std::span<const FreshCorner>(*corners); });
    // As a rule few.
    slices.add(gl::kBufferPieceBytes, [&water, pool, indices] {
        water.indices = pool->take(GL_ELEMENT_ARRAY_BUFFER, indices->size() * sizeof(std::uint32_t));
        water.indices->write<std::uint32_t>(0, *indices);
    });
}

WaterPass::WaterPass()
    : program_("water.vert", "water.frag"),
      fresh_program_("fresh_water.vert", "water.frag"),
      fresh_vertices_{{0,
                       sizeof(FreshCorner),
                       gl::Advance::PerVertex,
                       {{0, 4, GL_FLOAT, gl::Numbers::AsTheyAre, 0},
                        {1, 2, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(FreshCorner, current_m_s)}}}},
      vertices_{{0, sizeof(glm::vec2), gl::Advance::PerVertex, {{0, 2, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}}} {
    const auto vertices = ring_vertices();
    const auto indices = ring_indices();
    rings_ = gl::Buffer{GL_ARRAY_BUFFER, vertices.size() * sizeof(glm::vec2)};
    rings_.write<glm::vec2>(0, vertices);
    indices_ = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint16_t)};
    indices_.write<std::uint16_t>(0, indices);
    std::vector<std::vector<glm::vec3>> ways(kSectors);
    for (std::size_t i = 0; i < kSectors; ++i) {
        const glm::vec2 rim = vertices[vertices.size() - kSectors + i];
        ways[i].emplace_back(rim.x, 0, rim.y);
        ways[(i + kSectors - 1) % kSectors].emplace_back(rim.x, 0, rim.y);
    }
    sectors_ = choose::Sectors(std::move(ways), indices.size() / kSectors);
    gl::Slices slices;
    gl::TextureShape shape;
    shape.wrap_s = shape.wrap_t = gl::Wrap::Repeat;
    gl::add_picture(slices, ripples_, std::make_shared<mesh::Image>(ripples_and_gusts()), shape);
    while (!slices.advance(std::size_t{1} << 20U)) continue;
}

gl::Work WaterPass::draw(const gl::Texture2D& ground, const MirrorOnGpu& mirror, const choose::Frustum& frustum,
                         glm::vec3 eye_m, const choose::Reach& reach) const {
    program_.use();
    vertices_.bind();
    vertices_.feed(0, rings_.name());
    vertices_.feed_indices(indices_.name());
    bind_pictures(ground, mirror);
    const gl::Work work =
        draw_ranges(sectors_.seen(frustum, {eye_m.x, 0, eye_m.z}, rings_within(reach)), GL_UNSIGNED_SHORT);
    glDisable(GL_BLEND);
    return work;
}

gl::Work WaterPass::draw_fresh(const FreshWaterOnGpu& water, const gl::Texture2D& ground, const MirrorOnGpu& mirror,
                               std::span<const choose::Range> seen) const {
    if (seen.empty()) return {};
    fresh_program_.use();
    fresh_vertices_.bind();
    fresh_vertices_.feed(0, water.corners->name());
    fresh_vertices_.feed_indices(water.indices->name());
    bind_pictures(ground, mirror);
    const gl::Work work = draw_ranges(seen);
    glDisable(GL_BLEND);
    return work;
}

// The shore shows through shallow water; depth is still written, for the sky comes later.
void WaterPass::bind_pictures(const gl::Texture2D& ground, const MirrorOnGpu& mirror) const {
    ground.bind(0);
    ripples_.bind(1);
    mirror.picture->bind(2);
    gl::bind_uniforms(mirror.block, kMirrorBinding);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace quadrat::render::passes
