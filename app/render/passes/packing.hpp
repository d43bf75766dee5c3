// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render/choose/bytes.hpp"

// Vertex attributes in bytes: what a normal, a share or a colour loses by it is not seen.
namespace quadrat::render::passes {

using choose::unsigned_byte;

struct PackedNormal {
    std::int8_t x, y, z, w;
};

inline std::int8_t signed_byte(float value) {
    return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127.0F));
}
inline PackedNormal packed_normal(glm::vec3 unit) {
    return {signed_byte(unit.x), signed_byte(unit.y), signed_byte(unit.z), 0};
}

// Of what has no picture of its own.
struct Facing {
    PackedNormal normal;
    std::uint8_t root_colour[4];
};

}  // namespace quadrat::render::passes
