// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/image.hpp"

namespace quadrat::scene {

// What the water of a scene shows: the sky and what stands around the water, by bearing and height as they are seen
// from a place on its surface that the flight looks over. One picture serves the whole flight: each bearing knows how
// far away the shore is that stands in it, and a ray that leaves the water anywhere else is followed to there.
struct Mirror {
    static constexpr std::size_t kBearings = 64;  // of shore_m

    mesh::Image light;     // three of four channels: square root of a quarter of the light; rows from the
                           // horizon upward; empty: no water is seen
    glm::vec3 at_m{0};     // that place
    float middle_rad = 0;  // bearing of the picture's middle, clockwise from north
    std::array<float, kBearings> shore_m{};  // evenly over the picture

    static constexpr float kWide_rad = 3.6F;  // of the picture
    static constexpr float kLowFiner = 0.25F;

    friend bool operator==(const Mirror&, const Mirror&) = default;
};

// Texture coordinates of a bearing off the picture's middle and a rise over run; not clamped.
inline glm::vec2 mirror_at(float off_middle_rad, float rise) {
    return {off_middle_rad / Mirror::kWide_rad + 0.5F, rise * (1 + Mirror::kLowFiner) / (rise + Mirror::kLowFiner)};
}
inline float mirror_rise(float row) { return row * Mirror::kLowFiner / (1 + Mirror::kLowFiner - row); }

}  // namespace quadrat::scene
