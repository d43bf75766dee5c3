// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// Light of a whole sphere on a surface, by nine spherical harmonics (Ramamoorthi & Hanrahan, "An efficient
// representation for irradiance environment maps", 2001): within 3 % of the integral for any lit sky.
namespace quadrat::scene {

class Irradiance {
  public:
    // Adds what arrives from a direction (unit) out of a solid angle, sr.
    void add(const glm::vec3& direction, const glm::vec3& radiance, float solid_angle_sr);

    // Makes on(up) what it is by an integral of its own: a bright horizon has orders that nine harmonics leave out.
    void correct_level(const glm::vec3& on_level_ground);

    // Irradiance / pi on a surface with this normal (unit): what a white one sends back. Never below 0.
    glm::vec3 on(const glm::vec3& normal) const;

    // The same with the quadratic terms left out but for the vertical one, which goes into the constant and the linear
    // ones: on(up), on(down) and the mean over level normals stay. xyz times the normal plus w, for red, green and
    // blue.
    std::array<glm::vec4, 3> linear() const;

    friend bool operator==(const Irradiance&, const Irradiance&) = default;

  private:
    std::array<glm::vec3, 9> terms_{};  // of radiance, orders 0, 1 and 2
};

}  // namespace quadrat::scene
