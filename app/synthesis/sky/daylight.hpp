// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "scene/parameters_fwd.hpp"
#include "scene/sky.hpp"

namespace quadrat::synthesis::sky {

// Which lights stand in the sky, before there is any air.
struct Lights {
    explicit Lights(const scene::SkyParameters& parameters);

    glm::vec3 sun;  // toward it, unit; under the horizon by night
    float sun_height_deg;
    glm::vec3 moon;  // toward it, unit
    bool is_night;
    float darkness;  // 0 while the sun is up to 1 in deep night
    float lowness;   // 0 high sun to 1 at the horizon and below
    const glm::vec3& brightest() const { return is_night ? moon : sun; }
};

// How far the lower clouds close the sky to the sun, 0 to 1.
float overcast(const scene::SkyParameters& parameters);

// The clear sky and the light it lets through, exposed: a white, level ground in full light is about paper white by
// day, and so much darker by night as keeps a night a night and a scene readable.
struct Daylight {
    scene::Dome dome;
    glm::vec3 sunlight;    // irradiance / pi facing the light that casts shadows, of a sky without clouds
    glm::vec3 high_light;  // the same at the height of the clouds, of whatever lights them
    glm::vec3 sky_light;   // irradiance / pi of the dome on level ground
    float exposure;        // from the light of a sun of 1 outside the air
};

Daylight make_daylight(const scene::SkyParameters& parameters, const Lights& lights);

}  // namespace quadrat::synthesis::sky
