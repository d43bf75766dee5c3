// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/passes/crowd.hpp"

namespace quadrat::render::passes {

inline Kind tree() { return {12, 4, {2800, 1100, 180, 30, 6}, {0, 0.04F, 0.12F, 0.3F, 0.6F}, 2100, 2}; }
inline Kind grass() { return {0.4F, 0.2F, {}, {}, 9, 2}; }

inline Kind leafy() {
    Kind kind = tree();
    kind.mass_triangles = {240, 120, 60, 28, 14};
    kind.massed = 0.8F;
    return kind;
}

}  // namespace quadrat::render::passes
