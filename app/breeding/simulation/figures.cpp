// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {
namespace {

const Standing& standing_in(const std::vector<Standing>& standings, Method method) {
    const auto found = std::ranges::find(standings, method, &Standing::method);
    assert(found != standings.end());
    return *found;
}

Estimate after(const Standing& standing, std::size_t round) {
    const std::size_t i = std::min(round, standing.closeness.size()) - 1;
    return {standing.closeness[i], standing.standard_error[i]};
}

// As if both were independent; visitors are the same ones, so the truth is a little narrower.
Estimate difference(const Estimate& a, const Estimate& b) { return {a.value - b.value, std::hypot(a.error, b.error)}; }

Estimate ratio(const Estimate& a, const Estimate& b) {
    const double value = a.value / b.value;
    return {value, std::abs(value) * std::hypot(a.error / a.value, b.error / b.value)};
}

}  // namespace

Figures figures_of(const std::vector<Standing>& standings) {
    const Standing& belief = standing_in(standings, Method::Belief);
    const Standing& pbil = standing_in(standings, Method::Pbil);
    const Standing& novice = standing_in(standings, Method::SlidersNovice3);
    Figures figures;
    figures.after_5 = after(belief, 5);
    figures.of_projection = ratio(after(belief, 5), after(standing_in(standings, Method::Projection), 5));
    figures.times_pbil = ratio(after(belief, 5), after(pbil, 5));
    const double level = after(pbil, 15).value;
    const auto reached = std::ranges::find_if(belief.closeness, [&](double close) { return close >= level; });
    if (reached != belief.closeness.end())
        figures.rounds_to_pbil_15 = static_cast<int>(reached - belief.closeness.begin()) + 1;
    figures.worse = {belief.worse_share, belief.worse_error};
    figures.ahead_of_novice_5 = difference(after(belief, 5), after(novice, 5));
    figures.ahead_of_novice_8 = difference(after(belief, 8), after(novice, 8));
    return figures;
}

std::string text_of(const Figures& f) {
    return fmt::format(
        "belief, after 5 rounds                     {:.3f} ± {:.3f}\n"
        "  of what the words could reach            {:.2f} ± {:.2f}\n"
        "  times pbil                               {:.1f} ± {:.1f}\n"
        "  ahead of novice sliders, as many actions {:+.3f} ± {:.3f}; after 8 rounds {:+.3f} ± {:.3f}\n"
        "rounds to where pbil is after 15           {}\n"
        "rounds in which the best got visibly worse {:.1f} ± {:.1f} %\n",
        f.after_5.value, f.after_5.error, f.of_projection.value, f.of_projection.error, f.times_pbil.value,
        f.times_pbil.error, f.ahead_of_novice_5.value, f.ahead_of_novice_5.error, f.ahead_of_novice_8.value,
        f.ahead_of_novice_8.error, f.rounds_to_pbil_15 > 0 ? fmt::to_string(f.rounds_to_pbil_15) : "never",
        100 * f.worse.value, 100 * f.worse.error);
}

}  // namespace quadrat::breeding
