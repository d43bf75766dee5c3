// SPDX-License-Identifier: Apache-2.0
#include "render/passes/stone.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/picture_upload.hpp"
#include "render/passes/packing.hpp"
#include "scene/colour.hpp"

namespace quadrat::render::passes {
namespace {

// How well lichen grows at a corner, 0 to 1: on what lies open to the sky, not in caves, which are dark; here more,
// there less, over some ten metres.
float lichen_of(const choose::Pieces::Corner& corner) {
    const float open = std::clamp(0.55F + 0.6F * corner.normal.y, 0.0F, 1.0F);
    const float brightest = std::max({corner.colour.r, corner.colour.g, corner.colour.b});
    const glm::vec3& at = corner.at_m;
    const float here = 0.62F + 0.45F * std::sin(0.41F * at.x + 2 * std::sin(0.23F * at.z)) * std::cos(0.47F * at.y);
    return std::min(open * here, 1.0F) * std::clamp((brightest - 0.03F) / 0.06F, 0.0F, 1.0F);
}

// Rain throws earth against its foot, and little light comes there: so it lies on the ground, not before it.
float light_at_foot(const scene::Land& land, const glm::vec3& at_m) {
    constexpr float kFoot_m = 0.8F;
    constexpr float kLeast = 0.5F;
    const float over_m = at_m.y - scene::ground_height_m(land, {at_m.x, at_m.z});
    return kLeast + (1 - kLeast) * std::clamp(over_m / kFoot_m, 0.0F, 1.0F);
}

// In the sun what is paler would be a white sheet without form.
glm::vec3 shown_colour(const glm::vec3& colour) {
    constexpr float kPalest = 0.40F;
    return colour * std::min(kPalest / std::max(scene::luminance(colour), 1e-3F), 1.0F);
}

// Of stone without lichen: one pixel of none.
std::shared_ptr<const mesh::Image> lichen_on(const std::shared_ptr<const scene::Land>& land) {
    if (!land->lichen.bytes.empty()) return {land, &land->lichen};
    return std::make_shared<mesh::Image>(1, 1, 2);
}

Facing facing_of(const scene::Land& land, const choose::Pieces::Corner& corner) {
    const glm::vec3 colour = light_at_foot(land, corner.at_m) * shown_colour(corner.colour);
    const auto root = [&](int c) { return unsigned_byte(std::sqrt(std::max(colour[c], 0.0F))); };
    return {packed_normal(corner.normal), {root(0), root(1), root(2), unsigned_byte(lichen_of(corner))}};
}

}  // namespace

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Land>& land) {
    const scene::Stone& source = land->stone;
    const std::size_t most = choose::Pieces::most_corners(source);
    const auto corners = std::make_shared<std::vector<choose::Pieces::Corner>>();
    const auto facings = std::make_shared<std::vector<Facing>>();
    slices.prepare([&stone, &source, land, corners, facings, most] {
        stone.pieces = choose::Pieces(source);
        *corners = stone.pieces.take_corners();
        for (const choose::Pieces::Corner& corner : *corners) facings->push_back(facing_of(*land, corner));
        corners->resize(most);
        facings->resize(most);
    });
    gl::add_made<glm::vec3>(slices, stone.corners, GL_ARRAY_BUFFER, most,
                            [corners](std::size_t i) { return (*corners)[i].at_m; });
    gl::add_made<Facing>(slices, stone.facings, GL_ARRAY_BUFFER, most,
                         [facings](std::size_t i) { return (*facings)[i]; });
    const auto lichen = lichen_on(land);
    gl::TextureShape tiled;
    tiled.wrap_s = tiled.wrap_t = gl::Wrap::Repeat;
    tiled.width = lichen->width;
    tiled.height = lichen->height;
    tiled.channels = 2;
    gl::add_picture(slices, stone.lichen, lichen, tiled);
}

StonePass::StonePass()
    : program_("stone.vert", "stone.frag"),
      vertices_{{0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

gl::Work StonePass::draw(const StoneOnGpu& stone, const GroundPictureOnGpu& picture, const gl::StreamBuffer& indices,
                         const choose::IndexRange& range) const {
    if (range.count == 0) return {};
    program_.use();
    stone.lichen.bind(0);
    picture.grain->lit->bind(1);
    vertices_.bind();
    vertices_.feed(0, stone.corners.name());
    vertices_.feed(1, stone.facings.name());
    return draw_indices(vertices_, indices, range.first, range.count);
}

}  // namespace quadrat::render::passes
