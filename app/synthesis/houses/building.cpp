// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/colour.hpp"
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
    const std::size_t n = design.plan.size();
    const Look look{design.plinth.colour, design.plinth.cladding, 0};
    const auto top = static_cast<float>(design.plinth_m);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = design.plan[i];
        const glm::dvec2 q = design.plan[(i + 1) % n];
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

void add_chimneys(scene::Building& to, const Design& design, double ridge_m, base::Seed seed) {
    base::RandomStream random{seed.child("chimneys")};
    glm::dvec2 low = design.plan[0];
    glm::dvec2 high = low;
    for (const glm::dvec2 p : design.plan) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const float inward = design.form == RoofForm::Gabled ? 1.0F : 0.35F;  // a hip's ridge is short
    for (int i = 0; i < design.chimneys; ++i) {
        const float side = (i % 2 == 0) == (random.unit() < 0.5) ? -1.0F : 1.0F;
        const bool is_broad = design.is_gable.size() > 1 && design.is_gable[1];
        const auto half = 0.5F * static_cast<float>(is_broad ? high.x - low.x : 8.0);
        const auto depth = static_cast<float>(is_broad ? 8.0 : high.y - low.y);
        const float along = side * inward * half * random.between(0.45F, 0.7F);
        const float aside = random.between(0.35F, 0.8F);
        const glm::vec3 at = is_broad ? glm::vec3{along, 0, -aside}
                                      : glm::vec3{aside, 0, side * inward * 0.25F * depth * random.between(0.5F, 1)};
        const auto top = static_cast<float>(ridge_m) + random.between(0.55F, 0.95F);
        const float from = static_cast<float>(ridge_m) - 2.6F;
        const glm::vec3 brick = scene::shifted_colour(design.plinth.colour, 0.95F);
        add_everywhere(to, {{at.x, from, at.z}, {1, 0, 0}, {0.36F, top - from, 0.28F}},
                       {brick, scene::Cladding::Rubble, 0});
        add_everywhere(to, {{at.x, top, at.z}, {1, 0, 0}, {0.44F, 0.12F, 0.36F}},
                       {brick * 0.75F, scene::Cladding::Plain, 0}, 2);
        add_everywhere(to, {{at.x, top + 0.12F, at.z}, {1, 0, 0}, {0.14F, 0.26F, 0.14F}},
                       {{0.16F, 0.07F, 0.04F}, scene::Cladding::Plain, 0}, 1);
        to.chimneys_m.push_back({at.x, top + 0.4F, at.z});
    }
}

// A bell tower astride the front, under a steep pyramid.
void add_tower(scene::Building& to, const Design& design, base::Seed seed) {
    double front = -1e9;
    for (const glm::dvec2 p : design.plan) front = std::max(front, -p.y);
    constexpr double kHalf = 1.7;
    Design tower = design;
    tower.plan = plan_of(2 * kHalf, 2 * kHalf);
    for (glm::dvec2& p : tower.plan) p.y -= front;
    tower.is_gable.assign(4, false);
    tower.form = RoofForm::Hipped;
    tower.wall_m = design.tower_m;
    tower.pitch_deg = 68;
    tower.eave_m = 0.25;
    tower.chimneys = 0;
    tower.tower_m = 0;
    const glm::dvec2 half = to.half_m;
    const scene::Building whole = build(tower, seed.child("tower"));
    for (std::size_t level = 0; level < kLevels; ++level) {
        scene::Masses& masses = to.levels[level];
        const scene::Masses& add = whole.levels[level];
        const auto first = static_cast<std::uint32_t>(masses.mesh.positions_m.size());
        const auto append = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
        append(masses.mesh.positions_m, add.mesh.positions_m);
        append(masses.mesh.normals, add.mesh.normals);
        append(masses.mesh.texcoords, add.mesh.texcoords);
        append(masses.colours, add.colours);
        append(masses.claddings, add.claddings);
        append(masses.lamps, add.lamps);
        for (const std::uint32_t index : add.mesh.indices) masses.mesh.indices.push_back(first + index);
    }
    to.half_m = glm::max(half, glm::dvec2{kHalf, front + kHalf});
    to.height_m = std::max(to.height_m, whole.height_m);
}

}  // namespace

std::vector<glm::dvec2> plan_of(double width_m, double depth_m, double wing_width_m, double wing_m) {
    const double x = 0.5 * width_m;
    const double y = 0.5 * depth_m;
    if (wing_m <= 0) return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    const double w = 0.5 * wing_width_m;
    const double at = x - w;
    const double shift = -0.5 * wing_m;
    std::vector<glm::dvec2> plan{{-x, -y}, {x, -y}, {x, y + wing_m}, {at - w, y + wing_m}, {at - w, y}, {-x, y}};
    for (glm::dvec2& p : plan) p.y += shift;
    return plan;
}

scene::Building build(const Design& design, base::Seed seed) {
    scene::Building building;
    building.levels.resize(kLevels);
    const std::size_t n = design.plan.size();
    building.half_m = {0, 0};
    for (const glm::dvec2 p : design.plan) building.half_m = glm::max(building.half_m, glm::vec2(glm::abs(p)));
    add_plinth(building, design);
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 p = design.plan[i];
        const glm::dvec2 q = design.plan[(i + 1) % n];
        const double width = glm::length(q - p);
        const glm::dvec2 d = (q - p) / width;
        Side side{glm::vec3{p.x, design.plinth_m, -p.y}, {d.x, 0, -d.y}, {d.y, 0, d.x}, width, design.wall_m};
        if (design.is_gable[i] && design.form != RoofForm::Hipped) {
            side.gable_m = rise_m(design, width);
            side.gable_cut_m = hip_cut_m(design, width);
        }
        side.is_front = i == 0;
        add_side(building, design, side, seed);
        if (i == 0 && design.plinth_m > 0.2)
            add_steps(building, design, side.corner_m * glm::vec3{0, 0, 1}, side.along);
    }
    const double ridge_m = add_roof(building, design);
    building.height_m = static_cast<float>(ridge_m);
    add_chimneys(building, design, ridge_m, seed);
    if (design.tower_m > 0) add_tower(building, design, seed);
    return building;
}

}  // namespace quadrat::synthesis::houses
