// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "render/gl/buffer.hpp"

namespace quadrat::render::gl {

// Large buffers that are taken again when nobody holds them any more, for the reason that TexturePool gives.
class BufferPool {
  public:
    // At least so many bytes, for this target; nobody else's as long as it is held; what is in it is left from before.
    // A small one is new, and goes when it is let go.
    std::shared_ptr<Buffer> take(GLenum target, std::size_t bytes);
    // Keeps no more than so much that nobody holds; what was free longest goes first.
    void trim(std::size_t most_free_bytes);

  private:
    // What a generation leaves behind: the grids of its lands.
    static constexpr std::size_t kMostFreeBytes = 9U << 20U;

    struct Pooled {
        GLenum target;
        std::shared_ptr<Buffer> buffer;
    };
    std::vector<Pooled> pooled_;  // what was taken last comes last
};

}  // namespace quadrat::render::gl
