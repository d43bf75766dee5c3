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

// Bearings stand closer together toward the north, where flights look.
constexpr float kNorthFiner = 0.7F;
constexpr float kLowFiner = 0.2F;

glm::vec2 cloudscape_at(const glm::vec3& d) {
    const float bearing = std::atan2(d.x, -d.z);
    const float up = std::max(d.y, 0.0F);
    return {(bearing + kNorthFiner * std::sin(bearing)) / (2.0F * kPi) + 0.5F,
            up * (1.0F + kLowFiner) / (up + kLowFiner)};
}

glm::vec3 cloudscape_direction(const glm::vec2& at) {
    const float wanted = 2.0F * kPi * (at.x - 0.5F);
    float bearing = wanted / (1.0F + kNorthFiner);
    for (int i = 0; i < 12; ++i)
        bearing -= (bearing + kNorthFiner * std::sin(bearing) - wanted) / (1.0F + kNorthFiner * std::cos(bearing));
    const float up = std::clamp(at.y * kLowFiner / (1.0F + kLowFiner - at.y), 0.0F, 1.0F);
    const float flat = std::sqrt(1.0F - up * up);
    return {flat * std::sin(bearing), up, -flat * std::cos(bearing)};
}

Cloudscape cloudscape_of(const CloudLayer& flat, int width, int height) {
    if (flat.density.bytes.empty()) return {};
    Cloudscape picture(width, height, 2);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 d = cloudscape_direction({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                                                      (static_cast<float>(y) + 0.5F) / static_cast<float>(height)});
            const glm::vec2 tile =
                glm::fract(tile_at(flat, glm::vec2{d.x, d.z} * (flat.height_m / (d.y + kBendsDown))));
            const int column =
                std::min(static_cast<int>(tile.x * static_cast<float>(flat.density.width)), flat.density.width - 1);
            const int row =
                std::min(static_cast<int>(tile.y * static_cast<float>(flat.density.height)), flat.density.height - 1);
            const float opacity = flat.opacity * static_cast<float>(*flat.density.pixel(column, row));
            const float lit = flat.lit.bytes.empty() ? 1.0F : static_cast<float>(*flat.lit.pixel(column, row)) / 255.0F;
            picture.pixel(x, y)[0] = static_cast<std::uint8_t>(opacity + 0.5F);
            picture.pixel(x, y)[1] = static_cast<std::uint8_t>(opacity * lit + 0.5F);
        }
    }
    return picture;
}

float cloudscape_drift_rad(const CloudLayer& layer, float seconds) {
    constexpr float kFarthest_rad = 0.16F;
    constexpr float kSeen_m = 4000.0F;  // where most of what is looked at hangs
    const float speed = glm::length(layer.wind_m_s);
    if (speed <= 0) return 0;
    // Wind along the view moves them as well.
    const float aside = layer.wind_m_s.x + (layer.wind_m_s.x < 0 ? -0.4F : 0.4F) * std::abs(layer.wind_m_s.y);
    return kFarthest_rad * std::sin(seconds * aside / (kSeen_m * kFarthest_rad));
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
    const float clear = 1.0F - std::exp2(-22.0F * std::max(direction.y, 0.0F));
    for (auto layer = sky.clouds.rbegin(); layer != sky.clouds.rend(); ++layer) {
        const glm::vec3 cloud = glm::mix(layer->shaded, layer->sunlit, layer->mean_lit);
        seen = glm::mix(seen, cloud, layer->opacity * layer->mean_density * clear);
    }
    return seen;
}

}  // namespace quadrat::scene
