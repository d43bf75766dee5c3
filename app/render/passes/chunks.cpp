// SPDX-License-Identifier: Apache-2.0
#include "render/passes/chunks.hpp"

#include <epoxy/gl.h>

#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <utility>

#include "render/gl/buffer_upload.hpp"
#include "render/gl/wires.hpp"

namespace quadrat::render::passes {

Chunks::Chunks(const mesh::Mesh& mesh, float side_m) : index_count_(mesh.indices.size()) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> squares;  // row, column: first index of each triangle
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 corner = mesh.positions_m[mesh.indices[i]];
        squares[{static_cast<int>(std::floor(corner.z / side_m)), static_cast<int>(std::floor(corner.x / side_m))}]
            .push_back(i);
    }
    indices_.reserve(mesh.indices.size());
    for (const auto& [square, triangles] : squares) {
        const glm::vec3 any = mesh.positions_m[mesh.indices[triangles.front()]];
        Chunk chunk{{indices_.size(), 3 * triangles.size()}, any, any};
        for (const std::size_t first : triangles) {
            for (std::size_t k = first; k < first + 3; ++k) {
                const glm::vec3 at_m = mesh.positions_m[mesh.indices[k]];
                chunk.low_m = glm::min(chunk.low_m, at_m);
                chunk.high_m = glm::max(chunk.high_m, at_m);
                indices_.push_back(mesh.indices[k]);
            }
        }
        chunks_.push_back(chunk);
    }
}

std::vector<Chunks::Range> Chunks::seen(const Frustum& frustum) const {
    std::vector<Range> ranges;
    for (const Chunk& chunk : chunks_) {
        if (!frustum.may_see_box(chunk.low_m, chunk.high_m)) continue;
        const bool goes_on = !ranges.empty() && ranges.back().first + ranges.back().count == chunk.range.first;
        if (goes_on)
            ranges.back().count += chunk.range.count;
        else
            ranges.push_back(chunk.range);
    }
    return ranges;
}

gl::Work draw_ranges(std::span<const Chunks::Range> ranges, GLenum index_type) {
    gl::Work work;
    for (const Chunks::Range& range : ranges) {
        gl::draw_triangles(index_type, range.first, range.count);
        work += gl::work_of_mesh(range.count);
    }
    return work;
}

void add_chunks(gl::Slices& slices, Chunks& chunks, gl::Buffer& indices,
                const std::shared_ptr<const mesh::Mesh>& mesh) {
    const auto ordered = std::make_shared<std::vector<std::uint32_t>>();
    slices.prepare([&chunks, mesh, ordered] {
        chunks = Chunks(*mesh, kChunk_m);
        *ordered = chunks.take_indices();
    });
    gl::add_elements<std::uint32_t>(slices, indices, GL_ELEMENT_ARRAY_BUFFER, mesh->indices.size(),
                                    [ordered] { return std::span<const std::uint32_t>(*ordered); });
}

}  // namespace quadrat::render::passes
