// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

// Colours are linear Rec. 709 light unless a name says otherwise. OKLab: Björn Ottosson, "A perceptual color space for
// image processing", 2020.
namespace quadrat::scene {

// How bright a linear colour is (ITU-R BT.709).
inline float luminance(const glm::vec3& linear) { return 0.2126F * linear.r + 0.7152F * linear.g + 0.0722F * linear.b; }

glm::vec3 oklab_from_linear(const glm::vec3& linear);
glm::vec3 linear_from_oklab(const glm::vec3& lab);  // may lie outside [0, 1]

// Between two colours as the eye would mix them; t = 0 gives from, t = 1 gives to. Never below 0.
glm::vec3 mix_colours(const glm::vec3& from, const glm::vec3& to, float t);

// The same colour lighter or darker (times lightness) and more or less coloured (times chroma), in OKLab.
glm::vec3 shifted_colour(const glm::vec3& colour, float lightness, float chroma = 1);

float srgb_from_linear(float linear);  // clamped to [0, 1]
float linear_from_srgb(float encoded);
std::uint8_t srgb_byte(float linear);  // encoded, rounded
// The same for whole rows: entry i is the byte of the light (i / 4096)^2.
const std::array<std::uint8_t, 4097>& srgb_bytes_by_root();
glm::vec3 linear_from_srgb_hex(std::uint32_t rgb);  // 0xRRGGBB

}  // namespace quadrat::scene
