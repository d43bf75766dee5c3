// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/choose/crowd.hpp"

namespace quadrat::render::choose {

inline PlantKind tree() { return {12, 4, {2800, 1100, 180, 30, 6}, {0, 0.04F, 0.12F, 0.3F, 0.6F}, 2100, 2}; }
inline PlantKind grass() { return {0.4F, 0.2F, {}, {}, 9, 2}; }

inline PlantKind leafy() {
    PlantKind kind = tree();
    kind.mass_triangles = {240, 120, 60, 28, 14};
    kind.massed = 0.8F;
    return kind;
}

}  // namespace quadrat::render::choose
