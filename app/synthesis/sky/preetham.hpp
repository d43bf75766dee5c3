// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

namespace quadrat::synthesis::sky {

// Clear daylight as an analytic formula (Preetham, Shirley & Smits, "A practical analytic model for daylight", 1999).
// It holds for turbidities 2 to 6 and a sun more than about 5 degrees up; beyond that it turns dark, even negative.
class Preetham {
  public:
    // turbidity: 1 pure air to 10; sun_direction: unit, not under the horizon.
    Preetham(float turbidity, const glm::vec3& sun_direction);

    glm::vec3 zenith_yxy() const { return zenith_; }       // luminance, kcd/m2, and chromaticity x, y
    glm::vec3 yxy(const glm::vec3& direction) const;       // the same in a direction (unit, above the horizon)
    glm::vec3 radiance(const glm::vec3& direction) const;  // linear Rec. 709, of a sun of 1 outside the air; >= 0

  private:
    struct Perez {  // A to E for Y, x and y
        glm::vec3 a, b, c, d, e;
    };
    glm::vec3 perez(float cos_zenith, float gamma) const;

    Perez coefficients_;
    glm::vec3 sun_;
    glm::vec3 zenith_;
    glm::vec3 at_zenith_;  // of the distribution, by which it is divided
};

}  // namespace quadrat::synthesis::sky
