// SPDX-License-Identifier: Apache-2.0
#include "tempo/budget.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::tempo {
namespace {

constexpr float kLeastScale = 0.25F;

}  // namespace

float Budget::scale(double pixels_of_views, float most) const {
    if (pixels == 0) return most;
    return std::clamp(static_cast<float>(std::sqrt(static_cast<double>(pixels) / pixels_of_views)), kLeastScale, most);
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

}  // namespace quadrat::tempo
