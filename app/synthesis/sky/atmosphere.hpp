// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "mesh/field.hpp"

namespace quadrat::synthesis::sky {

// What the air is made of, against the earth's clean air.
struct Air {
    float turbidity = 2.8F;  // 1 clean air to 10: optical depth of air and haze to that of the air alone
    float molecules = 1;
    float ozone = 1;
    float forward = 0.8F;  // of the haze's phase function, -1 to 1
    float ground = 0.2F;   // albedo of the land below
};

// Sunlight scattered once by ray marching and more often by an isotropic estimate (Hillaire, "A scalable and production
// ready sky and atmosphere rendering technique", 2020), with the coefficients of Bruneton & Neyret 2008. It holds where
// analytic skies fail: for thick air, for a sun on the horizon and for one below it.
class Atmosphere {
  public:
    explicit Atmosphere(const Air& air);

    // The share of the sun's light that reaches the ground, per channel; sun_y: sine of its height. 0 once it has set.
    glm::vec3 transmittance(float sun_y) const;
    // Radiance from a direction (unit, not below the horizon) of a sun whose irradiance outside the air is 1.
    glm::vec3 radiance(const glm::vec3& direction, const glm::vec3& sun_direction) const;

    // 1/m at the ground: what the tests hold against the literature.
    glm::vec3 rayleigh_per_m() const { return rayleigh_; }
    float haze_per_m() const { return haze_scattering_; }

    static constexpr int kHeights = 10;
    static constexpr int kSuns = 20;

  private:
    glm::vec3 extinction(const glm::vec3& columns) const;
    glm::vec3 through(float height_m, float mu) const;
    glm::vec3 many_times(float height_m, float sun_y) const;
    void scatter_often();

    glm::vec3 rayleigh_{0};
    glm::vec3 ozone_{0};
    float haze_scattering_ = 0;
    float haze_extinction_ = 0;
    float forward_ = 0;
    float ground_ = 0;
    mesh::Grid<glm::vec3> often_;  // by height and the sun's: radiance scattered more than once, per unit of scattering
};

}  // namespace quadrat::synthesis::sky
