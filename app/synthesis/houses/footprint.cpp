// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "synthesis/houses/building.hpp"

namespace quadrat::synthesis::houses {
namespace {

void centre(std::vector<glm::dvec2>& plan) {
    glm::dvec2 low = plan.front();
    glm::dvec2 high = low;
    for (const glm::dvec2 p : plan) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    for (glm::dvec2& p : plan) p -= 0.5 * (low + high);
}

}  // namespace

bool is_gable(const Design& design, std::size_t side) {
    return design.footprint.is_gable[side] && design.form != RoofForm::Hipped && design.form != RoofForm::Mansard;
}

Footprint rectangle(double width_m, double depth_m, bool is_gable_front) {
    const double x = 0.5 * width_m;
    const double y = 0.5 * depth_m;
    return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {is_gable_front, !is_gable_front, is_gable_front, !is_gable_front}};
}

Footprint with_wing(const Footprint& rectangle, Wing wing, double width_m, double depth_m) {
    const glm::dvec2 a = rectangle.plan[0];
    const glm::dvec2 b = rectangle.plan[2];
    Footprint made;
    switch (wing) {
        case Wing::BackCorner:
            made.plan = {
                a, {b.x, a.y}, {b.x, b.y + depth_m}, {b.x - width_m, b.y + depth_m}, {b.x - width_m, b.y}, {a.x, b.y}};
            made.is_gable = {false, false, true, false, false, true};
            break;
        case Wing::BackMiddle:
            made.plan = {a,
                         {b.x, a.y},
                         b,
                         {0.5 * width_m, b.y},
                         {0.5 * width_m, b.y + depth_m},
                         {-0.5 * width_m, b.y + depth_m},
                         {-0.5 * width_m, b.y},
                         {a.x, b.y}};
            made.is_gable = {false, true, false, false, true, false, false, true};
            break;
        case Wing::Front:
            made.plan = {a, {b.x - width_m, a.y}, {b.x - width_m, a.y - depth_m}, {b.x, a.y - depth_m}, b, {a.x, b.y}};
            made.is_gable = {false, false, true, false, false, true};
            break;
    }
    centre(made.plan);
    return made;
}

Footprint mirrored(const Footprint& footprint) {
    const std::size_t n = footprint.plan.size();
    Footprint made;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = footprint.plan[(n + 1 - i) % n];
        made.plan.emplace_back(-p.x, p.y);
        made.is_gable.push_back(footprint.is_gable[(n - i) % n]);
    }
    return made;
}

glm::vec2 half_of(const Design& design) {
    glm::dvec2 half{0};
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    for (const glm::dvec2 p : plan) half = glm::max(half, glm::abs(p));
    for (const LeanTo& shed : design.lean_tos) {
        const glm::dvec2 from = plan[shed.side];
        const glm::dvec2 d = glm::normalize(plan[(shed.side + 1) % plan.size()] - from);
        for (const double along : {shed.from_m, shed.from_m + shed.width_m})
            half = glm::max(half, glm::abs(from + along * d + shed.depth_m * glm::dvec2{d.y, -d.x}));
    }
    if (design.tower_m > 0) half = glm::max(half, glm::dvec2{kTowerHalf_m, kTowerHalf_m + half.y});
    return glm::vec2(half);
}

}  // namespace quadrat::synthesis::houses
