// SPDX-License-Identifier: Apache-2.0
// Axes: the paper's z is our y, up; its y is our z.
#include "scene/irradiance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace quadrat::scene {
namespace {

std::array<float, 9> basis(const glm::vec3& d) {
    return {0.282095F,
            0.488603F * d.z,
            0.488603F * d.y,
            0.488603F * d.x,
            1.092548F * d.x * d.z,
            1.092548F * d.z * d.y,
            0.315392F * (3.0F * d.y * d.y - 1.0F),
            1.092548F * d.x * d.y,
            0.546274F * (d.x * d.x - d.z * d.z)};
}

// Of the clamped cosine, divided by pi, by order.
constexpr std::array<float, 9> kCosine{1.0F, 0.666667F, 0.666667F, 0.666667F, 0.25F, 0.25F, 0.25F, 0.25F, 0.25F};

}  // namespace

void Irradiance::add(const glm::vec3& direction, const glm::vec3& radiance, float solid_angle_sr) {
    const std::array<float, 9> y = basis(direction);
    for (std::size_t i = 0; i < y.size(); ++i) terms_[i] += radiance * (y[i] * solid_angle_sr);
}

// The vertical order of two gives and takes as the left-out order of four would: up against level.
void Irradiance::correct_level(const glm::vec3& on_level_ground) {
    constexpr std::size_t kVertical = 6;
    const float weight = basis({0, 1, 0})[kVertical] * kCosine[kVertical];
    terms_[kVertical] += (on_level_ground - on({0, 1, 0})) / weight;
}

glm::vec3 Irradiance::on(const glm::vec3& normal) const {
    const std::array<float, 9> y = basis(normal);
    glm::vec3 sum{0};
    for (std::size_t i = 0; i < y.size(); ++i) sum += terms_[i] * (y[i] * kCosine[i]);
    return glm::max(sum, glm::vec3{0});
}

std::array<glm::vec4, 3> Irradiance::linear() const {
    const glm::vec3 up = on({0, 1, 0});
    const glm::vec3 down = on({0, -1, 0});
    const glm::vec3 level = 0.25F * (on({1, 0, 0}) + on({-1, 0, 0}) + on({0, 0, 1}) + on({0, 0, -1}));
    const glm::vec3 east = 0.5F * (on({1, 0, 0}) - on({-1, 0, 0}));
    const glm::vec3 south = 0.5F * (on({0, 0, 1}) - on({0, 0, -1}));
    const glm::vec3 middle = 0.25F * (up + down) + 0.5F * level;
    std::array<glm::vec4, 3> rows{};
    for (int c = 0; c < 3; ++c) {
        // A low sun's glow would take all its red from a wall that looks away, and all light from a leaf that looks
        // away and down: nothing has less than a share of the mean.
        constexpr float kMost = 0.66F;
        constexpr float kMostAnyWay = 0.9F;
        const float steep = 0.5F * (up[c] - down[c]);
        const float left = std::sqrt(std::max(kMostAnyWay * kMostAnyWay * middle[c] * middle[c] - steep * steep, 0.0F));
        const float most = std::min(kMost * middle[c], left);
        const float aside = glm::length(glm::vec2{east[c], south[c]});
        const float kept = aside > most ? most / aside : 1.0F;
        rows[static_cast<std::size_t>(c)] = {kept * east[c], steep, kept * south[c], middle[c]};
    }
    return rows;
}

}  // namespace quadrat::scene
