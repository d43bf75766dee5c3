// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ranges.hpp"

#include "render/gl/wires.hpp"

namespace quadrat::render::passes {

gl::Work draw_ranges(std::span<const choose::Range> ranges, GLenum index_type) {
    gl::Work work;
    for (const choose::Range& range : ranges) {
        gl::draw_triangles(index_type, range.first, range.count);
        work += gl::work_of_mesh(range.count);
    }
    return work;
}

}  // namespace quadrat::render::passes
