// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

namespace quadrat::render::passes {

// One channel of shaders/common/encode.glsl: linear, exposed light to the display's 0 to 1.
inline float encode(float linear) {
    const float s = std::min(std::sqrt(std::max(linear, 0.0F)), 1.2F);
    return s * (1.007595F + s * (0.352583F - 0.406319F * s));
}

}  // namespace quadrat::render::passes
