// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

namespace quadrat::render::choose {

// Of an index buffer.
struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Range&, const Range&) = default;
};

// A run of indices in the frame's index stream, and what they were chosen for.
struct IndexRange {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t near_count = 0;  // of them come first, nearer than the grain is seen
    float ease = 0;              // shaders/common/grid.glsl
    std::size_t level = 0;       // whose colour its wires have
};

}  // namespace quadrat::render::choose
