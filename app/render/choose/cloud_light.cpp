// SPDX-License-Identifier: Apache-2.0
#include "render/choose/cloud_light.hpp"

#include <cmath>

namespace quadrat::render::choose {

float cloud_light_at(const ViewBlock& view, const mesh::Image& density, const glm::vec3& at_m) {
    if (density.bytes.empty()) return 1;
    const float u =
        view.shadow_place.x - view.shadow_place.z * at_m.y + view.shadow_turn.x * at_m.x + view.shadow_turn.z * at_m.z;
    const float v =
        view.shadow_place.y - view.shadow_place.w * at_m.y + view.shadow_turn.y * at_m.x + view.shadow_turn.w * at_m.z;
    // Between pixels, so that no tree blinks as the shadow's edge comes over it.
    const float column = (u - std::floor(u)) * static_cast<float>(density.width);
    const float row = (v - std::floor(v)) * static_cast<float>(density.height);
    const int x = static_cast<int>(column);
    const int y = static_cast<int>(row);
    const auto at = [&](int dx, int dy) {
        return static_cast<float>(*density.pixel((x + dx) & (density.width - 1), (y + dy) & (density.height - 1)));
    };
    const float tx = column - static_cast<float>(x);
    const float ty = row - static_cast<float>(y);
    const float above = at(0, 0) + tx * (at(1, 0) - at(0, 0));
    const float below = at(0, 1) + tx * (at(1, 1) - at(0, 1));
    return 1 - view.cloud_place[0].z * (above + ty * (below - above)) / 255;
}

}  // namespace quadrat::render::choose
