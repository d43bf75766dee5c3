// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/houses/additions.hpp"
#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/roofs.hpp"
#include "synthesis/houses/walls.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kInGround_m = 3.0F;  // how deep a foundation reaches: it stands on a slope

void add_everywhere(scene::Building& to, const Box& box, const Look& look, std::size_t levels = kLevels) {
    for (std::size_t level = 0; level < levels; ++level) add_box(to.levels[level], box, look);
}

// Stands out a hand's breadth below the walls, and steps lead up to the door.
void add_plinth(scene::Building& to, const Design& design) {
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    const std::size_t n = plan.size();
    const Look look{design.plinth.colour, design.plinth.cladding, 0};
    const auto top = static_cast<float>(design.plinth_m);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = plan[i];
        const glm::dvec2 q = plan[(i + 1) % n];
        const glm::dvec2 d = glm::normalize(q - p);
        const glm::vec3 out{0.07 * d.y, 0, 0.07 * d.x};
        const glm::vec3 along{0.07 * d.x, 0, -0.07 * d.y};
        const glm::vec3 a = glm::vec3{p.x, 0, -p.y} + out - along;
        const glm::vec3 b = glm::vec3{q.x, 0, -q.y} + out + along;
        const glm::vec3 low{0, -kInGround_m, 0};
        const glm::vec3 high{0, top, 0};
        const std::array<float, 4> shades{0.75F, 0.75F, 1, 1};
        for (std::size_t level = 0; level < kLevels; ++level)
            add_face(to.levels[level], std::array{a + low, b + low, b + high, a + high}, look, shades);
        add_face(to.levels[0], std::array{a + high, b + high, b + high - out, a + high - out}, look);
    }
}

void add_steps(scene::Building& to, const Design& design, const glm::vec3& at, const glm::vec3& along) {
    const Look look{design.plinth.colour * 1.15F, scene::Cladding::Plain, 0};
    const int steps = std::max(1, static_cast<int>(std::lround(design.plinth_m / 0.18)));
    const glm::vec3 out{-along.z, 0, along.x};
    for (int i = 0; i < steps; ++i) {
        const float high = static_cast<float>(design.plinth_m) * static_cast<float>(i + 1) / static_cast<float>(steps);
        const float reach = 0.30F * static_cast<float>(steps - i);
        const glm::vec3 foot = at + out * (0.5F * reach) - glm::vec3{0, 1, 0};
        add_everywhere(to, {foot, along, {0.75F, high + 1, 0.5F * reach}}, look, 2);
    }
}

}  // namespace

scene::Building build(const Design& design, base::Seed seed) {
    scene::Building building;
    building.levels.resize(kLevels);
    building.half_m = half_of(design);
    building.wear = design.wear;
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    const std::size_t n = plan.size();
    add_plinth(building, design);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = plan[i];
        const glm::dvec2 q = plan[(i + 1) % n];
        const double width = glm::length(q - p);
        const glm::dvec2 d = (q - p) / width;
        Side side{glm::vec3{p.x, design.plinth_m, -p.y}, {d.x, 0, -d.y}, {d.y, 0, d.x}, width, design.wall_m, {}, {}};
        if (is_gable(design, i))
            for (const glm::dvec2 over : gable_of(design, width))
                side.gable.push_back({over.x, design.wall_m + over.y});
        for (const LeanTo& shed : design.lean_tos)
            if (shed.side == i)
                side.covered.push_back(
                    {{shed.from_m - 0.4, -3}, {shed.from_m + shed.width_m + 0.4, shed.high_m + 0.2}});
        side.is_front = i == 0;
        add_side(building, design, side, seed);
        if (i == 0 && design.plinth_m > 0.2)
            add_steps(building, design,
                      side.corner_m * glm::vec3{1, 0, 1} + static_cast<float>(0.5 * width) * side.along, side.along);
    }
    const double ridge_m = add_roof(building, design);
    building.height_m = static_cast<float>(ridge_m);
    add_chimneys(building, design, ridge_m, seed);
    add_dormers(building, design, seed);
    add_lean_tos(building, design);
    if (design.tower_m > 0) add_tower(building, design, seed);
    add_climbers(building, design, seed.child("climbers"));
    return building;
}

}  // namespace quadrat::synthesis::houses
