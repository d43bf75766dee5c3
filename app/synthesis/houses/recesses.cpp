// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/recesses.hpp"

#include <algorithm>
#include <glm/vector_relational.hpp>

#include "synthesis/houses/masses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr double kSlack_m = 1.0e-6;

bool is_within(const Opening& inner, const Opening& outer) {
    return glm::all(glm::lessThanEqual(outer.low_m, inner.low_m + kSlack_m)) &&
           glm::all(glm::greaterThanEqual(outer.high_m, inner.high_m - kSlack_m));
}

Outline over(const Outline& outline, double y) { return left_of(outline, {0, y}, {1, y}); }
Outline under(const Outline& outline, double y) { return left_of(outline, {1, y}, {0, y}); }
Outline east_of(const Outline& outline, double x) { return left_of(outline, {x, 1}, {x, 0}); }
Outline west_of(const Outline& outline, double x) { return left_of(outline, {x, 0}, {x, 1}); }

}  // namespace

bool holds(const FacadePanel& panel, const Opening& opening) {
    return is_within(opening, {panel.low_m, panel.high_m, false, 0});
}

std::vector<Recess> recesses_of(const std::vector<FacadePanel>& panels, const std::vector<Opening>& openings) {
    std::vector<Recess> found;
    for (const Opening& opening : openings) {
        const bool is_nested = std::any_of(found.begin(), found.end(), [&](const Recess& other) {
            return is_within(opening, other.opening) || is_within(other.opening, opening);
        });
        if (is_nested) continue;
        for (std::size_t k = opening.panel; k-- > 0;) {
            if (!holds(panels[k], opening)) continue;
            found.push_back({opening, k});
            break;
        }
    }
    return found;
}

std::vector<Outline> without(const Outline& outline, const std::vector<Opening>& holes, std::vector<double> cuts_m) {
    for (const Opening& hole : holes) cuts_m.insert(cuts_m.end(), {hole.low_m.y, hole.high_m.y});
    std::sort(cuts_m.begin(), cuts_m.end());
    std::vector<Outline> pieces;
    const auto add = [&pieces](Outline piece) {
        if (piece.size() > 2) pieces.push_back(std::move(piece));
    };
    const auto add_band = [&](Outline band, double low, double high) {
        std::vector<glm::dvec2> gaps;
        for (const Opening& hole : holes)
            if (hole.low_m.y <= low + kSlack_m && hole.high_m.y >= high - kSlack_m)
                gaps.emplace_back(hole.low_m.x, hole.high_m.x);
        std::sort(gaps.begin(), gaps.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; });
        for (const glm::dvec2 gap : gaps) {
            add(west_of(band, gap.x));
            band = east_of(band, gap.y);
        }
        add(std::move(band));
    };
    Outline rest = outline;
    double low = -1.0e9;
    for (const double cut : cuts_m) {
        if (cut <= low + kSlack_m) continue;
        add_band(under(rest, cut), low, cut);
        rest = over(rest, cut);
        low = cut;
    }
    add_band(std::move(rest), low, 1.0e9);
    return pieces;
}

}  // namespace quadrat::synthesis::houses
