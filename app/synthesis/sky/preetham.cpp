// SPDX-License-Identifier: Apache-2.0
// Preetham, Shirley & Smits 1999, appendix: the five-parameter distribution of Perez, fitted by turbidity.
#include "synthesis/sky/preetham.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace quadrat::synthesis::sky {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSunlight_klx = 128.0F;  // of the sun outside the air: what 1 is for the scattered sky

// Lines of the appendix's two matrices: by T squared, T and 1; each by the sun's zenith angle, cubed first.
float chromaticity(float t, float s, const float (&m)[3][4]) {
    const float of[3] = {t * t, t, 1.0F};
    float sum = 0;
    for (int i = 0; i < 3; ++i) sum += of[i] * (((m[i][0] * s + m[i][1]) * s + m[i][2]) * s + m[i][3]);
    return sum;
}

glm::vec3 zenith_of(float t, float sun_zenith_rad) {
    constexpr float kX[3][4] = {{0.00166F, -0.00375F, 0.00209F, 0.0F},
                                {-0.02903F, 0.06377F, -0.03202F, 0.00394F},
                                {0.11693F, -0.21196F, 0.06052F, 0.25886F}};
    constexpr float kY[3][4] = {{0.00275F, -0.00610F, 0.00317F, 0.0F},
                                {-0.04214F, 0.08970F, -0.04153F, 0.00516F},
                                {0.15346F, -0.26756F, 0.06670F, 0.26688F}};
    const float chi = (4.0F / 9.0F - t / 120.0F) * (kPi - 2.0F * sun_zenith_rad);
    const float luminance = (4.0453F * t - 4.9710F) * std::tan(chi) - 0.2155F * t + 2.4192F;
    return {luminance, chromaticity(t, sun_zenith_rad, kX), chromaticity(t, sun_zenith_rad, kY)};
}

}  // namespace

Preetham::Preetham(float t, const glm::vec3& sun_direction)
    : coefficients_{{0.1787F * t - 1.4630F, -0.0193F * t - 0.2592F, -0.0167F * t - 0.2608F},
                    {-0.3554F * t + 0.4275F, -0.0665F * t + 0.0008F, -0.0950F * t + 0.0092F},
                    {-0.0227F * t + 5.3251F, -0.0004F * t + 0.2125F, -0.0079F * t + 0.2102F},
                    {0.1206F * t - 2.5771F, -0.0641F * t - 0.8989F, -0.0441F * t - 1.6537F},
                    {-0.0670F * t + 0.3703F, -0.0033F * t + 0.0452F, -0.0109F * t + 0.0529F}},
      sun_(sun_direction) {
    const float sun_zenith = std::acos(std::clamp(sun_.y, 0.0F, 1.0F));
    zenith_ = zenith_of(t, sun_zenith);
    at_zenith_ = perez(1.0F, sun_zenith);
}

glm::vec3 Preetham::perez(float cos_zenith, float gamma) const {
    const Perez& p = coefficients_;
    const float cosine = std::cos(gamma);
    return (1.0F + p.a * glm::exp(p.b / std::max(cos_zenith, 0.01F))) *
           (1.0F + p.c * glm::exp(p.d * gamma) + p.e * (cosine * cosine));
}

glm::vec3 Preetham::yxy(const glm::vec3& direction) const {
    const float gamma = std::acos(std::clamp(glm::dot(direction, sun_), -1.0F, 1.0F));
    return zenith_ * perez(direction.y, gamma) / at_zenith_;
}

glm::vec3 Preetham::radiance(const glm::vec3& direction) const {
    const glm::vec3 seen = yxy(direction);
    const float y = std::max(seen.x, 0.0F) / kSunlight_klx;
    const float per_y = y / std::max(seen.z, 1.0e-3F);
    const glm::vec3 xyz{seen.y * per_y, y, (1.0F - seen.y - seen.z) * per_y};
    return glm::max(glm::vec3{3.2406F * xyz.x - 1.5372F * xyz.y - 0.4986F * xyz.z,
                              -0.9689F * xyz.x + 1.8758F * xyz.y + 0.0415F * xyz.z,
                              0.0557F * xyz.x - 0.2040F * xyz.y + 1.0570F * xyz.z},
                    glm::vec3{0});
}

}  // namespace quadrat::synthesis::sky
