// SPDX-License-Identifier: Apache-2.0
#include "render/choose/air.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace quadrat::render::choose {
namespace {

float mist_between(const ViewBlock& view, float height_m) {
    const float eye = std::max(view.eye_seconds.y - view.mist.y, 0.0F) * view.mist.z;
    const float end = std::max(height_m - view.mist.y, 0.0F) * view.mist.z;
    const float span = std::abs(end - eye);
    const float above =
        span > 0.02F ? std::abs(std::exp2(-eye) - std::exp2(-end)) * 1.442695F / span : std::exp2(-0.5F * (eye + end));
    const float share = (span + 0.001F) / (std::abs(height_m - view.eye_seconds.y) * view.mist.z + 0.001F);
    return glm::mix(1.0F, above, std::min(share, 1.0F));
}

}  // namespace

glm::vec4 haze_at(const ViewBlock& view, glm::vec3 at_m) {
    const glm::vec3 ray = at_m - glm::vec3{view.eye_seconds};
    const float distance_m = glm::length(ray);
    const float between_m = std::max(0.5F * (at_m.y + view.eye_seconds.y), 0.0F);
    float depth = distance_m * view.haze_colour.w * std::exp2(-between_m * view.haze_sunward.w);
    if (view.mist.x > 0) depth += distance_m * view.mist.x * mist_between(view, at_m.y);
    const float rim = std::clamp((distance_m - 6000.0F) / 4500.0F, 0.0F, 1.0F);
    const float amount = std::max(1 - std::exp2(-depth), rim * rim);
    const float cos_to_glow = glm::dot(ray, glm::vec3{view.to_glow}) / std::max(distance_m, 1e-3F);
    const float facing = std::max(0.5F + 0.5F * cos_to_glow, 0.0F);
    const float sunward = facing * facing * facing * facing;
    return {glm::mix(glm::vec3{view.haze_colour}, glm::vec3{view.haze_sunward}, sunward), amount};
}

}  // namespace quadrat::render::choose
