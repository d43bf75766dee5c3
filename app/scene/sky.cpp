// SPDX-License-Identifier: Apache-2.0
#include "scene/sky.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace quadrat::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace

glm::vec2 tile_at(const CloudLayer& layer, const glm::vec2& m) {
    const glm::vec2 across{-layer.along.y, layer.along.x};
    return {glm::dot(m, across) / layer.tile_m, glm::dot(m, layer.along) / (layer.tile_m * layer.stretch)};
}

// Height by the square of the row from the horizon, as Hillaire 2020 spaces his.
glm::vec3 Dome::direction(int column, int row) {
    const float bearing = 2.0F * kPi * static_cast<float>(column) / static_cast<float>(kColumns - 1);
    const float up = 1.0F - static_cast<float>(row) / static_cast<float>(kRows - 1);
    const float height = 0.5F * kPi * up * up;
    return {std::cos(height) * std::sin(bearing), std::sin(height), -std::cos(height) * std::cos(bearing)};
}

glm::vec3 Dome::radiance(const glm::vec3& d) const {
    const float up = std::sqrt(std::asin(std::clamp(d.y, 0.0F, 1.0F)) / (0.5F * kPi));
    const float row = (1.0F - up) * static_cast<float>(kRows - 1);
    float turn = std::atan2(d.x, -d.z) / (2.0F * kPi);
    if (turn < 0) turn += 1.0F;
    const float column = turn * static_cast<float>(kColumns - 1);
    const int x = std::clamp(static_cast<int>(column), 0, kColumns - 2);
    const int y = std::clamp(static_cast<int>(row), 0, kRows - 2);
    const float tx = column - static_cast<float>(x);
    const float ty = row - static_cast<float>(y);
    return glm::mix(glm::mix(table_.at(x, y), table_.at(x + 1, y), tx),
                    glm::mix(table_.at(x, y + 1), table_.at(x + 1, y + 1), tx), ty);
}

glm::vec3 mean_radiance(const Sky& sky, const glm::vec3& direction) {
    glm::vec3 seen = sky.dome.radiance(direction);
    // As the sky's shader fades clouds into the air over the horizon.
    const float clear = std::clamp(direction.y * 14.0F, 0.0F, 1.0F);
    for (auto layer = sky.clouds.rbegin(); layer != sky.clouds.rend(); ++layer) {
        const glm::vec3 cloud = glm::mix(layer->shaded, layer->sunlit, layer->mean_lit);
        seen = glm::mix(seen, cloud, layer->opacity * layer->mean_density * clear);
    }
    return seen;
}

}  // namespace quadrat::scene
