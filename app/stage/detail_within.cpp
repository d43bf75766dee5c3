// SPDX-License-Identifier: Apache-2.0
#include "stage/detail_within.hpp"

#include <cmath>

namespace quadrat::stage {

render::Detail detail_within(const tempo::Budget& budget, glm::ivec2 size, const render::Detail& most,
                             const std::function<std::size_t(const render::Detail&)>& triangles_at) {
    render::Detail detail = most;
    detail.scale = budget.scale(static_cast<double>(size.x) * size.y, most.scale);
    if (budget.triangles == 0 || triangles_at(detail) <= budget.triangles) return detail;
    float fits = tempo::BudgetKeeper::kLeastAlpha;
    float too_fine = most.alpha;
    while (too_fine > 1.02F * fits) {
        detail.alpha = std::sqrt(fits * too_fine);
        (triangles_at(detail) <= budget.triangles ? fits : too_fine) = detail.alpha;
    }
    detail.alpha = fits;
    return detail;
}

}  // namespace quadrat::stage
