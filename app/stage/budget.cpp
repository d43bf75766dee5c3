// SPDX-License-Identifier: Apache-2.0
#include "stage/budget.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::stage {

namespace {

constexpr float kLeastAlpha = 0.01F;
constexpr float kLeastScale = 0.25F;

}  // namespace

float Budget::scale(glm::ivec2 size, float most) const {
    if (pixels == 0) return most;
    const float share = static_cast<float>(pixels) / (static_cast<float>(size.x) * static_cast<float>(size.y));
    return std::clamp(std::sqrt(share), kLeastScale, most);
}

void BudgetKeeper::drew(std::size_t triangles) {
    if (budget_.triangles == 0) return;
    const float share = static_cast<float>(budget_.triangles) / static_cast<float>(std::max<std::size_t>(triangles, 1));
    constexpr float kRoom = 1.1F;     // so much must be left before more is drawn
    constexpr float kSlower = 1.03F;  // and then it comes slowly: it would be seen
    if (share < 1)
        alpha_ *= std::max(0.97F * share, 0.3F);
    else if (share > kRoom)
        alpha_ *= kSlower;
    alpha_ = std::clamp(alpha_, kLeastAlpha, most_);
}

render::Detail detail_within(const Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at) {
    render::Detail detail = most;
    detail.scale = budget.scale(size, most.scale);
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

}  // namespace quadrat::stage
