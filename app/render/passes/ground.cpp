// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/wires.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSurroundBlock = 8;
// How much steeper what is far is lit than it is: its samples have lost what is small. Beside the land it is lit as
// that.
constexpr float kModelled = 1.6F;
constexpr float kModelledFrom_m = 320;  // beyond the land's edge

// Of the country around. Within the land its samples lie sunken: there the land's own ground counts.
PackedNormal surround_normal(const scene::Land& land, int column, int row) {
    const mesh::Field& field = land.surround_m;
    const float cell_m = land.surround_cell_m;
    const auto place_m = [&](int c, int r) {
        return cell_m * (glm::vec2{static_cast<float>(c), static_cast<float>(r)} -
                         0.5F * glm::vec2{static_cast<float>(field.columns - 1), static_cast<float>(field.rows - 1)});
    };
    const auto beyond_m = [&](glm::vec2 at_m) {
        return std::max(std::abs(at_m.x), std::abs(at_m.y)) - 0.5F * land.side_m();
    };
    const auto height_m = [&](int c, int r) {
        c = std::clamp(c, 0, field.columns - 1);
        r = std::clamp(r, 0, field.rows - 1);
        const glm::vec2 at_m = place_m(c, r);
        return beyond_m(at_m) < 0 ? scene::ground_height_m(land, at_m) : field.at(c, r);
    };
    const float far = std::clamp(beyond_m(place_m(column, row)) / kModelledFrom_m, 0.0F, 1.0F);
    const float modelled = 1 + (kModelled - 1) * far;
    return packed_normal(
        glm::normalize(glm::vec3{height_m(column - 1, row) - height_m(column + 1, row), 2 * cell_m / modelled,
                                 height_m(column, row - 1) - height_m(column, row + 1)}));
}

Facing facing_of(const scene::Land& land, std::size_t sample) {
    const mesh::Field& field = land.surround_m;
    const auto at = static_cast<int>(sample);
    const int column = at % field.columns;
    const int row = at / field.columns;
    Facing facing{surround_normal(land, column, row), {}};
    for (int c = 0; c < 3; ++c)
        facing.root_colour[c] = land.surround_albedo.bytes.empty()
                                    ? unsigned_byte(std::sqrt(land.far_colour[c]))
                                    : gl::root_of_srgb(land.surround_albedo.pixel(column, row)[c]);
    return facing;
}

bool is_wet(const mesh::Field& field) {
    return std::ranges::any_of(field.samples, [](float h) { return h < 0; });
}

}  // namespace

void add_land(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<gl::BufferPool>& pool,
              const std::shared_ptr<const scene::Land>& source) {
    land.side_m = source->side_m();
    slices.prepare([&land, source] { land.has_water = is_wet(source->height_m) || is_wet(source->surround_m); });
    add_grid(slices, land.land, pool, {source, &source->height_m}, {source, &source->kinds},
             {source->cell_m, kLandBlock, 0});
    if (source->surround_m.columns < 2) return;
    // Some of the surround reaches under the land's rim, so that nothing shines through between them.
    const float hole_m = source->side_m() / 2 - source->surround_cell_m;
    add_grid(slices, land.surround, pool, {source, &source->surround_m}, std::make_shared<mesh::Image>(),
             {source->surround_cell_m, kSurroundBlock, hole_m});
    gl::add_made<Facing>(slices, land.facings, GL_ARRAY_BUFFER, source->surround_m.samples.size(),
                         [source](std::size_t i) { return facing_of(*source, i); });
}

void add_roam(gl::Slices& slices, LandOnGpu& land, const std::shared_ptr<const scene::Land>& source) {
    slices.prepare(
        [&land, source] { land.land.roam = std::make_unique<mesh::Roam>(source->height_m, source->cell_m); });
}

GroundPass::GroundPass()
    : near_("near_ground.vert", "near_ground.frag"),
      far_("ground.vert", "ground.frag"),
      vertices_{{0, sizeof(GridPlace), gl::Advance::PerVertex, kPlaceAttributes}} {}

gl::Work GroundPass::draw(const LandOnGpu& land, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                          const choose::IndexRange& range, float grain_m) const {
    gl::Work work;
    if (range.count == 0) return work;
    picture.lit->bind(0);
    picture.grain->lit->bind(1);
    vertices_.bind();
    vertices_.feed(0, land.land.places->name());
    if (range.near_count > 0) {
        near_.use();
        set_grid(land.land, range);
        glUniform1f(1, 1 / grain_m);
        work += draw_indices(vertices_, indices, range.first, range.near_count);
    }
    if (range.near_count == range.count) return work;
    far_.use();
    gl::Wires::set_level(range.level);
    set_grid(land.land, range);
    glUniform1f(1, 1 / std::max(grain_m, 1.0F));
    work += draw_indices(vertices_, indices, range.first + range.near_count, range.count - range.near_count);
    return work;
}

SurroundPass::SurroundPass()
    : program_("surround.vert", "surround.frag"),
      vertices_{{0, sizeof(GridPlace), gl::Advance::PerVertex, kPlaceAttributes},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

gl::Work SurroundPass::draw(const LandOnGpu& land, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                            const choose::IndexRange& range) const {
    if (range.count == 0) return {};
    picture.grain->lit->bind(1);
    program_.use();
    set_grid(land.surround, range);
    vertices_.bind();
    vertices_.feed(0, land.surround.places->name());
    vertices_.feed(1, land.facings.name());
    return draw_indices(vertices_, indices, range.first, range.count);
}

}  // namespace quadrat::render::passes
