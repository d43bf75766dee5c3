// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/walls.hpp"
#include "synthesis/voxels/climber.hpp"

namespace quadrat::synthesis::houses {
namespace {

using voxels::Surroundings;
using voxels::Tendril;

constexpr float kCell_m = 0.34F;
constexpr std::array<std::size_t, kLevels> kEvery{1, 2, 5};  // of its tufts, a level
constexpr std::array<float, kLevels> kSize{1, 1.4F, 2.1F};

constexpr float kDoor_m = 0.9F;  // half its breadth, with room
constexpr float kDoorHigh_m = 2.4F;

// Panes and roofs stay free.
Surroundings::Kind kind_of(const scene::Masses& masses, std::size_t vertex) {
    const scene::Cladding cladding = masses.claddings[vertex];
    const bool is_roof = cladding == scene::Cladding::Tiles || cladding == scene::Cladding::Slates ||
                         cladding == scene::Cladding::Thatch;
    return is_roof || masses.lamps[vertex] > 0 ? Surroundings::Kind::Bare : Surroundings::Kind::Hold;
}

Surroundings surroundings_of(const scene::Building& building, const Design& design) {
    const glm::vec3 half{building.half_m.x + 0.6F, 0, building.half_m.y + 0.6F};
    Surroundings around(-half - glm::vec3{0, 0.4F, 0}, half + glm::vec3{0, building.height_m, 0}, kCell_m);
    const scene::Masses& near = building.levels.front();
    const auto& at = near.mesh.positions_m;
    const auto& indices = near.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        around.add_face(at[indices[i]], at[indices[i + 1]], at[indices[i + 2]], kind_of(near, indices[i]));
    // The door, in the middle of the front.
    const glm::dvec2 p = design.footprint.plan[0];
    const glm::dvec2 q = design.footprint.plan[1];
    const glm::dvec2 d = glm::normalize(q - p);
    const glm::vec3 door{0.5 * (p.x + q.x), design.plinth_m, -0.5 * (p.y + q.y)};
    const glm::vec3 along = kDoor_m * glm::vec3{d.x, 0, -d.y};
    const glm::vec3 high{0, kDoorHigh_m, 0};
    around.add_face(door - along, door + along, door + along + high, Surroundings::Kind::Bare);
    around.add_face(door - along, door + along + high, door - along + high, Surroundings::Kind::Bare);
    return around;
}

// A tuft of leaves: five corners, no two alike, that hang before the wall.
void add_tuft(scene::Masses& to, const Tendril& tendril, float radius_m, const Look& look, base::RandomStream& random) {
    const glm::vec3 out = glm::normalize(
        tendril.out + 0.35F * glm::vec3{random.between(-1, 1), random.between(-0.2F, 1), random.between(-1, 1)});
    const glm::vec3 side = glm::normalize(glm::cross(glm::vec3{0.01F, 1, 0.02F}, out));
    const glm::vec3 up = glm::cross(out, side);
    const glm::vec3 middle = tendril.at_m + random.between(0.02F, 0.12F) * tendril.out;
    const float turn = random.between(0, 6.2831853F);
    std::array<glm::vec3, 5> corners;
    std::array<float, 5> shades{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const float angle = turn + 1.2566371F * static_cast<float>(k);
        const float reach = radius_m * random.between(0.75F, 1.25F);
        corners[k] = middle + reach * (std::cos(angle) * side + std::sin(angle) * up);
        shades[k] = 0.85F + 0.3F * std::sin(angle);
    }
    add_face(to, corners, look, shades);
}

}  // namespace

void add_climbers(scene::Building& to, const Design& design, base::Seed seed) {
    if (design.overgrown <= 0) return;
    base::RandomStream random{seed.child("roots")};
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    double around_m = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) around_m += glm::length(plan[(i + 1) % plan.size()] - plan[i]);
    // They are planted at the corners, where there is no door.
    const std::size_t many = 1 + static_cast<std::size_t>(design.overgrown * random.between(1, 4));
    std::vector<glm::vec3> roots;
    for (std::size_t i = 0; i < many; ++i) {
        const glm::dvec2 corner = plan[random.below(static_cast<std::uint32_t>(plan.size()))];
        roots.push_back({corner.x, 0.15, -corner.y});
    }
    voxels::Climber climber;
    climber.upward = 0.2F;
    climber.branching = 0.6F;
    climber.high_m = 1.2F + design.overgrown * static_cast<float>(design.wall_m + 2.5);
    const double walls_m2 = around_m * design.wall_m;
    climber.most = static_cast<std::size_t>(std::clamp(design.overgrown * 1.6 * walls_m2, 30.0, 320.0));
    const std::vector<Tendril> shoots = climb(surroundings_of(to, design), roots, climber, seed.child("shoots"));
    const glm::vec3 colour = voxels::climber_colour(design.redness, seed.child("colour"));
    for (std::size_t level = 0; level < kLevels; ++level)
        for (std::size_t i = 0; i < shoots.size(); i += kEvery[level]) {
            base::RandomStream own{seed.child("tufts").child(i)};
            const Look look{colour * own.between(0.7F, 1.35F), scene::Cladding::Leaves, 0};
            add_tuft(to.levels[level], shoots[i], kSize[level] * own.between(0.26F, 0.40F), look, own);
        }
}

}  // namespace quadrat::synthesis::houses
