// SPDX-License-Identifier: Apache-2.0
#include "scene/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/srgb.hpp"

namespace quadrat::scene {

glm::vec3 oklab_from_linear(const glm::vec3& c) {
    const float l = std::cbrt(0.4122214708F * c.x + 0.5363325363F * c.y + 0.0514459929F * c.z);
    const float m = std::cbrt(0.2119034982F * c.x + 0.6806995451F * c.y + 0.1073969566F * c.z);
    const float s = std::cbrt(0.0883024619F * c.x + 0.2817188376F * c.y + 0.6299787005F * c.z);
    return {0.2104542553F * l + 0.7936177850F * m - 0.0040720468F * s,
            1.9779984951F * l - 2.4285922050F * m + 0.4505937099F * s,
            0.0259040371F * l + 0.7827717662F * m - 0.8086757660F * s};
}

glm::vec3 linear_from_oklab(const glm::vec3& lab) {
    const float l_ = lab.x + 0.3963377774F * lab.y + 0.2158037573F * lab.z;
    const float m_ = lab.x - 0.1055613458F * lab.y - 0.0638541728F * lab.z;
    const float s_ = lab.x - 0.0894841775F * lab.y - 1.2914855480F * lab.z;
    const float l = l_ * l_ * l_;
    const float m = m_ * m_ * m_;
    const float s = s_ * s_ * s_;
    return {4.0767416621F * l - 3.3077115913F * m + 0.2309699292F * s,
            -1.2684380046F * l + 2.6097574011F * m - 0.3413193965F * s,
            -0.0041960863F * l - 0.7034186147F * m + 1.7076147010F * s};
}

namespace {
glm::vec3 not_negative(const glm::vec3& c) { return {std::max(c.x, 0.0F), std::max(c.y, 0.0F), std::max(c.z, 0.0F)}; }
}  // namespace

glm::vec3 mix_colours(const glm::vec3& from, const glm::vec3& to, float t) {
    const glm::vec3 a = oklab_from_linear(from);
    const glm::vec3 b = oklab_from_linear(to);
    return not_negative(linear_from_oklab(a + (b - a) * t));
}

glm::vec3 shifted_colour(const glm::vec3& colour, float lightness, float chroma) {
    glm::vec3 lab = oklab_from_linear(colour);
    lab.x *= lightness;
    lab.y *= chroma;
    lab.z *= chroma;
    return not_negative(linear_from_oklab(lab));
}

float srgb_from_linear(float linear) { return base::srgb_from_linear(linear); }

float linear_from_srgb(float encoded) { return base::linear_from_srgb(encoded); }

// A table over the square root of the light: exact to half a step and far cheaper than a power a pixel.
const std::array<std::uint8_t, 4097>& srgb_bytes_by_root() {
    static const std::array<std::uint8_t, 4097> table = [] {
        std::array<std::uint8_t, 4097> t{};
        for (std::size_t i = 0; i < t.size(); ++i) {
            const float root = static_cast<float>(i) / 4096.0F;
            t[i] = static_cast<std::uint8_t>(std::lround(255.0F * srgb_from_linear(root * root)));
        }
        return t;
    }();
    return table;
}

std::uint8_t srgb_byte(float linear) {
    // Written so that what is not a number is black.
    const float root = linear > 0.0F ? std::sqrt(std::min(linear, 1.0F)) : 0.0F;
    return srgb_bytes_by_root()[static_cast<std::size_t>(root * 4096.0F + 0.5F)];
}

glm::vec3 linear_from_srgb_hex(std::uint32_t rgb) {
    const auto channel = [rgb](unsigned shift) {
        return linear_from_srgb(static_cast<float>((rgb >> shift) & 255U) / 255.0F);
    };
    return {channel(16), channel(8), channel(0)};
}

}  // namespace quadrat::scene
