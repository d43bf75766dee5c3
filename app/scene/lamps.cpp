// SPDX-License-Identifier: Apache-2.0
#include "scene/lamps.hpp"

#include <cmath>
#include <glm/common.hpp>

namespace quadrat::scene {

float lit_windows(const Settlement& settlement, const Sky& sky) {
    // They are what a night has of warm light: a village without is a shed.
    constexpr float kLeastByNight = 0.35F;
    if (sky.is_night) return kLeastByNight + (1 - kLeastByNight) * settlement.lit_share;
    return settlement.lit_share * 0.9F * (1 - glm::smoothstep(0.05F, 0.24F, sky.sun_direction.y));
}

bool is_lit(float lamp, float evening, float lit_share) {
    if (lamp <= 0) return false;
    const float hour = lamp + evening;
    return hour - std::floor(hour) < lit_share;
}

}  // namespace quadrat::scene
