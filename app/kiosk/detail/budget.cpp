// SPDX-License-Identifier: Apache-2.0
#include "kiosk/detail/budget.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::kiosk {

render::Detail detail_within(const Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at) {
    constexpr float kLeastAlpha = 0.01F;
    constexpr float kLeastScale = 0.25F;
    render::Detail detail = most;
    if (budget.pixels > 0) {
        const float share =
            static_cast<float>(budget.pixels) / (static_cast<float>(size.x) * static_cast<float>(size.y));
        detail.scale = std::clamp(std::sqrt(share), kLeastScale, most.scale);
    }
    if (budget.triangles == 0 || triangles_at(detail) <= budget.triangles) return detail;
    float fits = kLeastAlpha;
    float too_fine = most.alpha;
    while (too_fine > 1.02F * fits) {
        detail.alpha = std::sqrt(fits * too_fine);
        (triangles_at(detail) <= budget.triangles ? fits : too_fine) = detail.alpha;
    }
    detail.alpha = fits;
    return detail;
}

}  // namespace quadrat::kiosk
