// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <span>

#include "render/choose/ranges.hpp"
#include "render/gl/work.hpp"

namespace quadrat::render::passes {

// Of the index buffer that is bound.
gl::Work draw_ranges(std::span<const choose::Range> ranges, GLenum index_type = GL_UNSIGNED_INT);

}  // namespace quadrat::render::passes
