// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace quadrat::render::passes {

// shaders/common/encode.glsl: linear, exposed light to what the display is given, 0 to 1.
inline float encode_root(float root) {
    const float s = std::min(root, 1.2F);
    return s * (1.007595F + s * (0.352583F - 0.406319F * s));
}
inline float encode(float light) { return encode_root(std::sqrt(std::max(light, 0.0F))); }
inline glm::vec3 encode(glm::vec3 light) { return {encode(light.r), encode(light.g), encode(light.b)}; }

}  // namespace quadrat::render::passes
