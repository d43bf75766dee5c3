// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/work.hpp"
#include "render/passes/frustum.hpp"

namespace quadrat::render::passes {

// A mesh that stands still, ordered by squares of the ground, so that those out of sight are not drawn.
class Chunks {
  public:
    struct Range {
        std::size_t first = 0;  // index
        std::size_t count = 0;
        friend bool operator==(const Range&, const Range&) = default;
    };

    Chunks() = default;
    Chunks(const mesh::Mesh& mesh, float side_m);

    // The mesh's triangles in the order the ranges count in; once.
    std::vector<std::uint32_t> take_indices() { return std::move(indices_); }
    std::size_t index_count() const { return index_count_; }

    // What may be seen, neighbours in one range.
    std::vector<Range> seen(const Frustum& frustum) const;

  private:
    struct Chunk {
        Range range;
        glm::vec3 low_m;
        glm::vec3 high_m;
    };
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> indices_;
    std::size_t index_count_ = 0;
};

// Of the index buffer that is bound.
gl::Work draw_ranges(std::span<const Chunks::Range> ranges, GLenum index_type = GL_UNSIGNED_INT);

inline constexpr float kChunk_m = 48;

// Adds the slices that fill chunks and indices, which must stay where they are until they are done.
void add_chunks(gl::Slices& slices, Chunks& chunks, gl::Buffer& indices, const std::shared_ptr<const mesh::Mesh>& mesh);

}  // namespace quadrat::render::passes
