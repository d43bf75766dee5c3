// SPDX-License-Identifier: Apache-2.0
#include "render/passes/stone.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Land>& land) {
    const scene::Stone& source = land->stone;
    const std::size_t most = Pieces::most_corners(source);
    const auto corners = std::make_shared<std::vector<Pieces::Corner>>();
    slices.prepare([&stone, &source, land, corners, most] {
        stone.pieces = Pieces(source);
        *corners = stone.pieces.take_corners();
        corners->resize(most);
    });
    gl::add_made<glm::vec3>(slices, stone.corners, GL_ARRAY_BUFFER, most,
                            [corners](std::size_t i) { return (*corners)[i].at_m; });
    gl::add_made<Facing>(slices, stone.facings, GL_ARRAY_BUFFER, most, [corners](std::size_t i) {
        const Pieces::Corner& corner = (*corners)[i];
        const auto root = [&](int c) { return unsigned_byte(std::sqrt(std::max(corner.colour[c], 0.0F))); };
        return Facing{packed_normal(corner.normal), {root(0), root(1), root(2), 0}};
    });
}

StonePass::StonePass()
    : program_("stone.vert", "lit.frag"),
      vertices_{{0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

gl::Work StonePass::draw(const StoneOnGpu& stone, const gl::StreamBuffer& indices, const IndexRange& range) const {
    if (range.count == 0) return {};
    program_.use();
    vertices_.bind();
    vertices_.feed(0, stone.corners.name());
    vertices_.feed(1, stone.facings.name());
    return draw_indices(vertices_, indices, range.first, range.count);
}

}  // namespace quadrat::render::passes
