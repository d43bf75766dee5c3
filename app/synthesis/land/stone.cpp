// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/stone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <numbers>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/facets.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Ball {
    std::vector<glm::vec3> corners;
    std::vector<std::array<int, 3>> faces;
};

// An icosahedron, each face cut in four where finer is wanted.
Ball ball(bool is_finer) {
    const float g = 0.5F + 0.5F * std::sqrt(5.0F);
    Ball b;
    b.corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    b.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (glm::vec3& c : b.corners) c = glm::normalize(c);
    if (!is_finer) return b;
    std::vector<std::array<int, 3>> finer;
    const auto middle = [&b](int i, int k) {
        const glm::vec3 m = glm::normalize(b.corners[i] + b.corners[k]);
        for (std::size_t n = 12; n < b.corners.size(); ++n)
            if (glm::dot(b.corners[n], m) > 0.99999F) return static_cast<int>(n);
        b.corners.push_back(m);
        return static_cast<int>(b.corners.size() - 1);
    };
    for (const auto& [i, j, k] : b.faces) {
        const int a = middle(i, j);
        const int c = middle(j, k);
        const int d = middle(k, i);
        finer.insert(finer.end(), {{i, a, d}, {a, j, c}, {d, c, k}, {a, c, d}});
    }
    b.faces = std::move(finer);
    return b;
}

void add_boulders(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                  base::Seed seed) {
    constexpr float kCell_m = 13.0F;
    constexpr std::size_t kMost = 150;
    const scene::Land& land = ground.land;
    const float half_m = 0.5F * land.side_m() - 30.0F;
    const float stony = p.ground_scree_slope - 0.18F;
    struct Candidate {
        float rank;
        glm::vec2 at_m;
        float radius_m;
        std::uint64_t name;
    };
    std::vector<Candidate> candidates;
    const int cells = static_cast<int>(half_m / kCell_m);
    for (int row = -cells; row < cells; ++row) {
        for (int column = -cells; column < cells; ++column) {
            const std::uint64_t name = base::hash_of(seed, column, row);
            base::RandomStream random{base::Seed{name}};
            const glm::vec2 at = kCell_m * glm::vec2{static_cast<float>(column) + random.unit_f(),
                                                     static_cast<float>(row) + random.unit_f()};
            const float chance = random.unit_f();
            const float size = random.unit_f();
            const float from_viewer_m = glm::length(at - kViewer_m);
            if (from_viewer_m > 430.0F || from_viewer_m < 9.0F) continue;
            const float slope = slope_at(land, at);
            if (chance > 0.02F + 0.55F * std::clamp((slope - stony) / 0.3F, 0.0F, 1.0F)) continue;
            if (scene::water_depth_m(land, at) > 0.6F || scene::ground_height_m(land, at) < -0.6F) continue;
            float radius_m = 0.35F + 2.6F * size * size * size * size;
            if (std::abs(at.x) < 170.0F && at.y > 190.0F && at.y < 410.0F) radius_m = std::min(radius_m, 0.75F);
            if (scene::to_road_m(land, at) < radius_m + 0.8F) continue;
            candidates.push_back({from_viewer_m / (1.0F + 2.0F * radius_m), at, radius_m, name});
        }
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.name < b.name;
    });
    if (candidates.size() > kMost) candidates.resize(kMost);
    for (const Candidate& c : candidates) {
        base::RandomStream random{base::Seed{c.name}.child("shape")};
        add_boulder(stones, strata, {c.at_m.x, scene::ground_height_m(land, c.at_m), c.at_m.y}, c.radius_m, random);
    }
}

}  // namespace

float slope_at(const scene::Land& land, glm::vec2 at_m) {
    const glm::vec3 n = scene::ground_normal(land, at_m);
    return std::sqrt(std::max(0.0F, 1.0F - n.y * n.y)) / std::max(n.y, 0.05F);
}

bool is_in_sight(const scene::Land& land, const glm::vec3& point) {
    const float eye_m = std::max(scene::ground_height_m(land, kViewer_m), 0.0F) + 5.0F;
    for (float share = 0.08F; share < 0.97F; share += 0.06F) {
        const glm::vec2 at = kViewer_m + share * (glm::vec2{point.x, point.z} - kViewer_m);
        if (scene::ground_height_m(land, at) > eye_m + share * (point.y - eye_m)) return false;
    }
    return true;
}

glm::vec3 Strata::at(float height_m, float wander) const {
    const float turn = 2 * kPi * (height_m / bed_m_ + 0.3F * wander);
    return scene::mix_colours(dark_, light_, 0.62F + 0.38F * contrast_ * std::sin(turn));
}

void add_facet(scene::Stone& stone, const std::array<glm::vec3, 3>& corners, const std::array<glm::vec3, 3>& colours) {
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::dot(across, across) < 1.0e-12F) return;
    const glm::vec3 normal = glm::normalize(across);
    for (std::size_t i = 0; i < 3; ++i) {
        stone.mesh.indices.push_back(static_cast<std::uint32_t>(stone.mesh.positions_m.size()));
        stone.mesh.positions_m.push_back(corners[i]);
        stone.mesh.normals.push_back(normal);
        stone.colours.push_back(colours[i]);
    }
}

void round_off(scene::Stone& stone, std::size_t from, float share) {
    const auto place = [&stone](std::size_t i) {
        const glm::vec3& at = stone.mesh.positions_m[i];
        return std::array{at.x, at.y, at.z};
    };
    std::map<std::array<float, 3>, glm::vec3> meeting;
    for (std::size_t i = from; i < stone.mesh.positions_m.size(); ++i)
        meeting.try_emplace(place(i), 0.0F).first->second += stone.mesh.normals[i];
    for (std::size_t i = from; i < stone.mesh.positions_m.size(); ++i) {
        const glm::vec3 sum = meeting.at(place(i));
        const float length = glm::length(sum);
        if (length < 1.0e-3F) continue;
        // A brow stays sharp.
        constexpr float kSharp = 0.3F;
        glm::vec3& normal = stone.mesh.normals[i];
        if (glm::dot(normal, sum) > kSharp * length) normal = glm::normalize(glm::mix(normal, sum / length, share));
    }
}

void add_boulder(Stones& stones, const Strata& strata, const glm::vec3& foot_m, float radius_m,
                 base::RandomStream& random) {
    static const Ball coarse = ball(false);
    static const Ball fine = ball(true);
    const Ball& from = radius_m > 1.4F ? fine : coarse;
    const glm::vec3 spread{random.between(0.8F, 1.3F), random.between(0.55F, 0.95F), random.between(0.8F, 1.2F)};
    const float yaw = random.between(0, 2 * kPi);
    // Cut by some planes, as rock breaks.
    std::array<glm::vec4, 5> cuts{};
    for (glm::vec4& cut : cuts)
        cut = {glm::normalize(glm::vec3{random.between(-1, 1), random.between(-0.3F, 1), random.between(-1, 1)}),
               random.between(0.62F, 0.9F)};
    const float tint = random.between(0.85F, 1.12F);
    std::vector<glm::vec3> corners;
    for (glm::vec3 c : from.corners) {
        c *= random.between(0.9F, 1.12F);
        for (const glm::vec4& cut : cuts) {
            const float over = glm::dot(c, glm::vec3{cut}) - cut.w;
            if (over > 0) c -= over * glm::vec3{cut};
        }
        c *= spread;
        c = {c.x * std::cos(yaw) + c.z * std::sin(yaw), c.y, c.z * std::cos(yaw) - c.x * std::sin(yaw)};
        corners.push_back(foot_m + radius_m * (c + glm::vec3{0, 0.25F, 0}));
    }
    for (const auto& face : from.faces) {
        std::array<glm::vec3, 3> at{};
        std::array<glm::vec3, 3> colours{};
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = corners[face[i]];
            const float up = std::clamp((at[i].y - foot_m.y) / radius_m, -0.3F, 1.0F);
            colours[i] = strata.at(at[i].y, tint) * tint * (0.62F + 0.38F * std::clamp(0.4F + up, 0.0F, 1.0F));
        }
        add_facet(stones.stone, at, colours);
    }
    stones.footprints.push_back({{foot_m.x, foot_m.z}, radius_m});
}

Stones make_stones(const StoneGround& ground, const scene::LandParameters& p, base::Seed seed) {
    Stones stones;
    const Strata strata(ground.palette, p);
    add_boulders(stones, ground, p, strata, seed.child("boulders"));
    if (p.arch_share > 0) {
        add_caves(stones, ground, p, strata, seed.child("caves"));
        if (p.arch_height_m < kTallestFin_m)
            add_fin(stones, ground, p, strata, seed.child("fin"));
        else
            add_arches(stones, ground, p, strata, seed);
    }
    if (p.wall_share > 0) add_field_walls(stones, ground, p, seed.child("walls"));
    if (p.ledge_share > 0)
        add_rock_ledges(stones, ground, p, strata, seed.child("ledges"));
    else
        add_standing_stones(stones, ground.land, strata, seed.child("ring"));
    if (p.climber_share > 0) add_rock_climbers(stones, ground, p, seed.child("climbers"));
    return stones;
}

void shade_under(mesh::Image& albedo, float side_m, const std::vector<Footprint>& footprints) {
    const float per_m = static_cast<float>(albedo.width) / side_m;
    const float half = 0.5F * static_cast<float>(albedo.width);
    for (const Footprint& f : footprints) {
        const float reach_m = 1.7F * f.radius_m + 0.6F;
        const glm::vec2 middle = f.at_m * per_m + half;
        const int reach = static_cast<int>(std::ceil(reach_m * per_m));
        for (int y = static_cast<int>(middle.y) - reach; y <= static_cast<int>(middle.y) + reach; ++y) {
            for (int x = static_cast<int>(middle.x) - reach; x <= static_cast<int>(middle.x) + reach; ++x) {
                if (x < 0 || y < 0 || x >= albedo.width || y >= albedo.height) continue;
                const glm::vec2 d = (glm::vec2{static_cast<float>(x), static_cast<float>(y)} + 0.5F - middle) / per_m;
                const float t = std::clamp(1.0F - glm::length(d) / reach_m, 0.0F, 1.0F);
                const float left = 1.0F - 0.42F * t * (2.0F - t);
                for (int c = 0; c < 3; ++c)
                    albedo.pixel(x, y)[c] = static_cast<std::uint8_t>(left * static_cast<float>(albedo.pixel(x, y)[c]));
            }
        }
    }
}

}  // namespace quadrat::synthesis::land
