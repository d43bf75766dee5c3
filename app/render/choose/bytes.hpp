// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quadrat::render::choose {

// A share, 0 to 1 or held within that, as the GPU reads it.
inline std::uint8_t unsigned_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

}  // namespace quadrat::render::choose
