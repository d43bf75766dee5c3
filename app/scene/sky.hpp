// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/image.hpp"

namespace quadrat::scene {

// Colours are linear and already exposed: 1 is paper white.
struct CloudLayer {
    mesh::Image density;  // one channel, tileable: opacity after the cover and sharpness filter
    mesh::Image lit;      // one channel, tileable, the same size: 0 shaded to 255 sunlit
    float tile_m = 6000;
    float height_m = 900;      // above the sea
    glm::vec2 wind_m_s{6, 2};  // x east, y south
    glm::vec3 sunlit{1};
    glm::vec3 shaded{0.6F};
    float opacity = 1;
};

struct Sky {
    glm::vec3 sun_direction{0, 1, 0};  // toward the sun, unit
    glm::vec3 sunlight{1};             // irradiance / pi on a surface facing the sun
    glm::vec3 light_above{0.3F};       // ambient radiance that arrives from above,
    glm::vec3 light_around{0.25F};     // from the horizon,
    glm::vec3 light_below{0.15F};      // and from the ground
    mesh::Image dome;                  // RGBA, colour: x azimuth from north clockwise over 360 deg, y from the
                                       // zenith (row 0) to 10 deg under the horizon; without sun and clouds
    glm::vec3 sun_colour{1};           // of the disc and its glow
    std::array<CloudLayer, 2> clouds;  // lower, upper
    glm::vec3 haze_colour{0.7F};       // looking across the sun
    glm::vec3 haze_sunward{0.9F};      // looking toward the sun
    float haze_distance_m = 1700;      // transmittance exp(-d / haze_distance_m)
    float haze_height_m = 500;         // density falls with height by exp(-h / haze_height_m)
};

}  // namespace quadrat::scene
