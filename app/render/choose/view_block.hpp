// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace quadrat::render::choose {

// What every pass knows of its view: the std140 mirror of shaders/common/view.glsl, which says what each number is.
struct ViewBlock {
    glm::mat4 clip_from_world{1};
    glm::vec4 eye_seconds{0};
    glm::vec4 to_sun{0};
    glm::vec4 to_glow{0};
    glm::vec4 sunlight{1};
    std::array<glm::vec4, 3> ambient{};
    glm::vec4 scales{1};
    glm::vec4 haze_colour{0};
    glm::vec4 haze_sunward{0};
    glm::vec4 mist{0, 0, 1, 26};
    glm::vec4 eye_snow{1, 0, 0, 0};
    glm::vec4 shallow_water{0};
    glm::vec4 deepening{0};
    glm::vec4 mirrored{0};
    glm::vec4 disc{0};
    glm::vec4 glare{0};
    std::array<glm::vec4, 2> cloud_turn{};
    std::array<glm::vec4, 2> cloud_place{};
    glm::vec4 shadow_turn{0};
    glm::vec4 shadow_place{0};
    glm::vec4 cloud_shaded{0};
    glm::vec4 cloud_gain{0};
};

// Views lie in one buffer at multiples of what a Raspberry Pi aligns uniform blocks to.
inline constexpr std::size_t kViewBlockBytes = (sizeof(ViewBlock) + 255) / 256 * 256;
inline constexpr unsigned kViewBinding = 0;

}  // namespace quadrat::render::choose
