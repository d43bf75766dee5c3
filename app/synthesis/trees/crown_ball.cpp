// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/crown_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "mesh/nearness.hpp"
#include "synthesis/trees/crown_reach.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kFewEnough = 0.75F;  // of a level's triangles, for another
constexpr float kWithin = 0.75F;     // cosine: what of the crown lies that way
constexpr float kRound = 0.92F;      // of its farthest point: flat triangles between such would look too large
constexpr float kArmless = 0.6F;     // where nothing of the crown lies that way

struct Sphere {
    std::vector<glm::vec3> directions;
    std::vector<std::uint32_t> indices;
};

Sphere octahedron() {
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {0, 2, 4, 4, 2, 1, 1, 2, 5, 5, 2, 0, 4, 3, 0, 1, 3, 4, 5, 3, 1, 0, 3, 5}};
}

// Each triangle as four.
Sphere divided(const Sphere& coarse) {
    Sphere fine{coarse.directions, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.directions.size()));
        if (is_new) fine.directions.push_back(glm::normalize(fine.directions[a] + fine.directions[b]));
        return at->second;
    };
    for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> at{coarse.indices[i], coarse.indices[i + 1], coarse.indices[i + 2]};
        const std::array<std::uint32_t, 3> mid{middle(at[0], at[1]), middle(at[1], at[2]), middle(at[2], at[0])};
        for (std::size_t k = 0; k < 3; ++k) fine.indices.insert(fine.indices.end(), {at[k], mid[k], mid[(k + 2) % 3]});
        fine.indices.insert(fine.indices.end(), {mid[0], mid[1], mid[2]});
    }
    return fine;
}

// The vertex of the crown that lies farthest this way, and how far; among those about it if there are any.
std::pair<std::size_t, float> farthest(const mesh::Mesh& crown, const glm::vec3& about_m, const glm::vec3& direction) {
    std::pair<std::size_t, float> within{0, 0.0F};
    std::pair<std::size_t, float> any{0, -1e9F};
    for (std::size_t i = 0; i < crown.positions_m.size(); ++i) {
        const glm::vec3 off_m = crown.positions_m[i] - about_m;
        const float far_m = glm::dot(off_m, direction);
        if (far_m > any.second) any = {i, far_m};
        if (far_m > kWithin * glm::length(off_m) && far_m > within.second) within = {i, far_m};
    }
    if (within.second > 0) return {within.first, kRound * within.second};
    return {any.first, kArmless * std::max(any.second, 0.05F)};
}

scene::CrownMass wrapped(const scene::CrownMass& crown, const Sphere& sphere) {
    glm::vec3 about_m{0};
    for (const glm::vec3& at_m : crown.mesh.positions_m) about_m += at_m;
    about_m /= static_cast<float>(crown.mesh.positions_m.size());
    const float most_m = reach_m(crown.mesh);
    scene::CrownMass mass;
    mass.share = crown.share;
    mass.mesh.indices = sphere.indices;
    for (const glm::vec3& direction : sphere.directions) {
        const auto [like, far_m] = farthest(crown.mesh, about_m, direction);
        mass.mesh.positions_m.push_back(within(about_m + far_m * direction, most_m));
        mass.mesh.normals.push_back(direction);
        mass.colours.push_back(crown.colours[like]);
        mass.shades.push_back(crown.shades[like]);
        mass.ages.push_back(crown.ages[like]);
        mass.sways.push_back(crown.sways[like]);
    }
    return mass;
}

}  // namespace

void add_ball(std::vector<scene::CrownMass>& masses, Ball ball) {
    if (masses.empty()) return;
    const Sphere sphere = ball == Ball::Of32 ? divided(octahedron()) : octahedron();
    scene::CrownMass& last = masses.back();
    const auto most = static_cast<std::size_t>(kFewEnough * static_cast<float>(last.mesh.triangle_count()));
    if (sphere.indices.size() / 3 > most) return;
    scene::CrownMass next = wrapped(masses.front(), sphere);
    const mesh::Nearness surface(next.mesh);
    last.coarser_m.clear();
    for (const glm::vec3& at_m : last.mesh.positions_m) last.coarser_m.push_back(surface.nearest(at_m).at_m);
    masses.push_back(std::move(next));
}

}  // namespace quadrat::synthesis::trees
