// SPDX-License-Identifier: Apache-2.0
#include "render/passes/stone.hpp"

#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "render/gl/buffer_upload.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {

void add_stone(gl::Slices& slices, StoneOnGpu& stone, const std::shared_ptr<const scene::Scene>& scene) {
    const scene::Stone& source = scene->land->stone;
    const mesh::Mesh& mesh = source.mesh;
    if (mesh.indices.empty()) return;
    gl::add_elements<glm::vec3>(slices, stone.corners, GL_ARRAY_BUFFER, {scene, &mesh.positions_m});
    gl::add_made<Facing>(slices, stone.facings, GL_ARRAY_BUFFER, mesh.positions_m.size(),
                         [scene, &source](std::size_t i) {
                             const auto root = [&](int c) { return unsigned_byte(std::sqrt(source.colours[i][c])); };
                             return Facing{packed_normal(source.mesh.normals[i]), {root(0), root(1), root(2), 0}};
                         });
    add_chunks(slices, stone.chunks, stone.indices, {scene, &mesh});
}

StonePass::StonePass()
    : program_("stone.vert", "lit_ground.frag"),
      vertices_{{0, sizeof(glm::vec3), gl::Advance::PerVertex, {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, 0}}},
                {1,
                 sizeof(Facing),
                 gl::Advance::PerVertex,
                 {{2, 4, GL_BYTE, gl::Numbers::Normalised, 0},
                  {4, 3, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(Facing, root_colour)}}}} {}

std::size_t StonePass::draw(const StoneOnGpu& stone, const Frustum& frustum) const {
    const std::vector<Chunks::Range> seen = stone.chunks.seen(frustum);
    if (seen.empty()) return 0;
    program_.use();
    vertices_.bind();
    vertices_.feed(0, stone.corners.name());
    vertices_.feed(1, stone.facings.name());
    vertices_.feed_indices(stone.indices.name());
    return draw_ranges(seen);
}

}  // namespace quadrat::render::passes
