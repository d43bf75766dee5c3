// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string>

#include "scene/sky.hpp"

// Whether a sky's light is of numbers: a picture hides what is not, for an encoder makes it black or white.
namespace quadrat::tests {

inline bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline bool is_finite(const scene::Dome& dome) {
    for (int row = 0; row < scene::Dome::kRows; ++row)
        for (int column = 0; column < scene::Dome::kColumns; ++column)
            if (!is_finite(dome.radiance(scene::Dome::direction(column, row)))) return false;
    return true;
}

inline bool is_finite(const scene::Irradiance& light) {
    for (const glm::vec4& colour : light.linear())
        if (!is_finite(glm::vec3{colour}) || !std::isfinite(colour.w)) return false;
    return true;
}

inline bool is_finite(const scene::CloudLayer& cloud) {
    return is_finite(cloud.sunlit) && is_finite(cloud.shaded) && std::isfinite(cloud.opacity) &&
           std::isfinite(cloud.mean_density) && std::isfinite(cloud.mean_lit);
}

// Empty: all of it is.
inline std::string not_finite(const scene::Sky& sky, float exposure) {
    if (!is_finite(sky.dome)) return "the dome is no number";
    if (!is_finite(sky.ambient) || !is_finite(sky.light_below)) return "the ambient light is no number";
    if (!is_finite(sky.sunlight)) return "the sunlight is no number";
    if (!is_finite(sky.haze_colour) || !is_finite(sky.haze_sunward)) return "the haze is no number";
    if (!std::isfinite(sky.haze_distance_m) || !std::isfinite(sky.mist.per_m)) return "the air's depth is no number";
    for (const scene::CloudLayer& cloud : sky.clouds)
        if (!is_finite(cloud)) return "a cloud's light is no number";
    if (!std::isfinite(exposure)) return "the exposure is no number";
    return {};
}

}  // namespace quadrat::tests
