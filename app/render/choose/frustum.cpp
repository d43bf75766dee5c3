// SPDX-License-Identifier: Apache-2.0
#include "render/choose/frustum.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace quadrat::render::choose {

Frustum::Frustum(const glm::mat4& clip_from_world) {
    const glm::mat4 rows = glm::transpose(clip_from_world);
    for (int axis = 0; axis < 3; ++axis) {
        planes_[static_cast<std::size_t>(2 * axis)] = rows[3] + rows[axis];
        planes_[static_cast<std::size_t>(2 * axis + 1)] = rows[3] - rows[axis];
    }
    for (glm::vec4& plane : planes_) plane /= std::max(glm::length(glm::vec3{plane}), 1e-12F);
}

bool Frustum::may_see_sphere(glm::vec3 middle_m, float radius_m) const {
    return std::ranges::all_of(planes_,
                               [&](const glm::vec4& p) { return glm::dot(glm::vec3{p}, middle_m) + p.w >= -radius_m; });
}

bool Frustum::may_see_cone(glm::vec3 apex_m, std::span<const glm::vec3> ways) const {
    constexpr std::size_t kFar = 5;  // hides nothing here
    return std::all_of(planes_.begin(), planes_.begin() + kFar, [&](const glm::vec4& p) {
        // A side goes through the eye, but for a rounding error.
        if (glm::dot(glm::vec3{p}, apex_m) + p.w > 1e-2F) return true;
        return std::ranges::any_of(ways, [&](const glm::vec3& way) { return glm::dot(glm::vec3{p}, way) > 0; });
    });
}

bool Frustum::may_see_box(glm::vec3 low_m, glm::vec3 high_m) const {
    return std::ranges::all_of(planes_, [&](const glm::vec4& p) {
        const glm::vec3 foremost{p.x > 0 ? high_m.x : low_m.x, p.y > 0 ? high_m.y : low_m.y,
                                 p.z > 0 ? high_m.z : low_m.z};
        return glm::dot(glm::vec3{p}, foremost) + p.w >= 0;
    });
}

bool Frustum::sees_whole_box(glm::vec3 low_m, glm::vec3 high_m) const {
    return std::ranges::all_of(planes_, [&](const glm::vec4& p) {
        const glm::vec3 hindmost{p.x > 0 ? low_m.x : high_m.x, p.y > 0 ? low_m.y : high_m.y,
                                 p.z > 0 ? low_m.z : high_m.z};
        return glm::dot(glm::vec3{p}, hindmost) + p.w >= 0;
    });
}

}  // namespace quadrat::render::choose
