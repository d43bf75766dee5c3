// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "scene/colour.hpp"

namespace quadrat::render::passes {

// shaders/common/encode.glsl: linear, exposed light to what the display is given, 0 to 1.
inline float encode_root(float root) {
    const float s = std::min(root, 1.2F);
    return s * (1.007595F + s * (0.352583F - 0.406319F * s));
}
inline float encode(float light) { return encode_root(std::sqrt(std::max(light, 0.0F))); }

// A sky's light, which may be many times paper white, brought under it by its brightness: alike up to a half.
inline glm::vec3 held(const glm::vec3& light) {
    const float y = scene::luminance(light);
    constexpr float kAlike = 0.5F;
    constexpr float kMost = 0.95F;
    if (y <= kAlike) return light;
    const float held_y = kAlike + (kMost - kAlike) * (1 - std::exp((kAlike - y) / (kMost - kAlike)));
    // What is far too bright pales.
    const float pale = std::min(0.35F * (y - held_y) / (y + 0.5F), 0.6F);
    const glm::vec3 scaled = light * (held_y / y);
    return scaled + (glm::vec3{held_y} - scaled) * pale;
}

inline glm::vec3 encode(glm::vec3 light) { return {encode(light.r), encode(light.g), encode(light.b)}; }

}  // namespace quadrat::render::passes
