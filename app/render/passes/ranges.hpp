// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <cstddef>
#include <span>

#include "render/gl/work.hpp"

namespace quadrat::render::passes {

// Of an index buffer.
struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

// Of the index buffer that is bound.
gl::Work draw_ranges(std::span<const Range> ranges, GLenum index_type = GL_UNSIGNED_INT);

}  // namespace quadrat::render::passes
