// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/settlement.hpp"

// How faces come into masses. Not for use from outside.
namespace quadrat::synthesis::houses {

inline constexpr glm::vec3 kSnow{0.80F, 0.83F, 0.88F};  // its colour, linear

struct Look {
    glm::vec3 colour{0.5F};  // linear
    scene::Cladding cladding = scene::Cladding::Plain;
    float lamp = 0;
};

// A convex face, counter-clockwise seen from outside; shades: a factor of the colour for each corner, or none.
void add_face(scene::Masses& to, std::span<const glm::vec3> corners, const Look& look,
              std::span<const float> shades = {});

// A box along two level unit directions; without its lower face.
struct Box {
    glm::vec3 foot_m{0};  // the middle of its lower side
    glm::vec3 across{1, 0, 0};
    glm::vec3 half_m{1};  // across, up (the whole height), deep
};
void add_box(scene::Masses& to, const Box& box, const Look& look, float foot_shade = 1);

// What of a convex polygon lies on the left of a line from a to b.
std::vector<glm::dvec2> left_of(const std::vector<glm::dvec2>& polygon, glm::dvec2 a, glm::dvec2 b);

}  // namespace quadrat::synthesis::houses
