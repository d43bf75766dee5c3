// SPDX-License-Identifier: Apache-2.0
#include "breeding/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::breeding {
namespace {

double root_mean_square(const Point& numbers) {
    double sum = 0;
    for (const double number : numbers) sum += number * number;
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(numbers.size(), 1)));
}

}  // namespace

std::optional<double> doubt_left(const Breeder& breeder) {
    const BeliefState* belief = breeder.layered_belief();
    if (belief == nullptr) return std::nullopt;
    double sum = 0;
    int judged = 0;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (belief->locked[aspect]) continue;
        const Atlas& atlas = belief->map.atlas(aspect);
        sum += root_mean_square(word_deviation(atlas, belief->layered[aspect])) /
               root_mean_square(word_deviation(atlas, initial_belief(atlas)));
        ++judged;
    }
    return judged == 0 ? std::nullopt : std::optional(sum / judged);
}

Agreement agreement(const Breeder& before, const Breeder& now) {
    const auto then = doubt_left(before);
    const auto left = doubt_left(now);
    if (!then || !left) return {};
    return {*left <= kNarrowDoubt, *left > *then};
}

}  // namespace quadrat::breeding
