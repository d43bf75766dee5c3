// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

namespace quadrat::render::gl {

// What the GPU is asked to do, before anything is out of sight or hidden.
struct Work {
    std::size_t draws = 0;
    std::size_t triangles = 0;
    std::size_t vertices = 0;  // each once a draw and instance

    Work& operator+=(const Work& o) {
        draws += o.draws;
        triangles += o.triangles;
        vertices += o.vertices;
        return *this;
    }
};

// One draw of a mesh most of whose vertices belong to six triangles.
inline Work work_of_mesh(std::size_t indices) { return {1, indices / 3, indices / 5}; }

}  // namespace quadrat::render::gl
