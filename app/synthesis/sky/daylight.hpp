// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "scene/parameters.hpp"

namespace quadrat::synthesis::sky {

// The clear sky as an illustrator's gradient: zenith to horizon, a glow about the sun, the dusk's rose opposite a low
// sun. Not a physical model; exposed so that 1 is paper white at every hour.
class Daylight {
  public:
    explicit Daylight(const scene::SkyParameters& parameters);

    glm::vec3 sun_direction() const { return sun_; }
    glm::vec3 sunlight() const { return sunlight_; }       // irradiance / pi, facing the sun
    glm::vec3 sun_colour() const { return sun_colour_; }   // of its light, the brightest channel 1
    glm::vec3 radiance(const glm::vec3& direction) const;  // unit direction; below the horizon: the haze
    float lowness() const { return lowness_; }             // 0 high sun to 1 at the horizon

  private:
    glm::vec3 sun_{0, 1, 0};
    glm::vec3 sunlight_{1};
    glm::vec3 sun_colour_{1};
    glm::vec3 zenith_lab_{0};
    glm::vec3 middle_lab_{0};
    glm::vec3 horizon_lab_{0};
    glm::vec3 dusk_{0};
    glm::vec3 glow_{0};
    float lowness_ = 0;
    float haziness_ = 0;
};

}  // namespace quadrat::synthesis::sky
