// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Where a plant's parts stand around their axis (Vogel, "A better way to construct the sunflower head", 1979; ABOP
// chapter 4): part n at the angle n · 137.5°.
namespace quadrat::synthesis::trees {

inline constexpr float kGoldenAngle_rad = 2.39996323F;

// Part n of a flat head, from its middle: φ = n · 137.5°, r = c √n.
glm::vec2 floret(int n, float c);

// Part n of so many on a body of revolution about y, of height 1 and widest radius 1, each with the same area: cones
// and buds. Its place, and by outward the direction away from the body there, unit.
glm::vec3 scale_on_cone(int n, int count, glm::vec3& outward);

}  // namespace quadrat::synthesis::trees
