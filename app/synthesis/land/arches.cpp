// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "synthesis/land/facets.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// A tube of rock along a curve: rings of sides, closed at both ends.
struct Ring {
    glm::vec3 middle_m;
    glm::vec3 along;
    float radius_m;
    float flat;  // height of the ring to its breadth
};

void add_tube(Stones& stones, const std::vector<Ring>& rings, int sides, float lump_m, noise::Key lumps,
              const Strata& strata, const scene::Land& land) {
    std::vector<glm::vec3> corners;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const Ring& ring = rings[i];
        const glm::vec3 level =
            glm::normalize(glm::cross(ring.along, glm::vec3{0.001F, 1, 0.002F}) + glm::vec3{1.0e-4F, 0, 0});
        const glm::vec3 up = glm::cross(level, ring.along);
        for (int side = 0; side < sides; ++side) {
            const float turn = 2 * kPi * static_cast<float>(side) / static_cast<float>(sides);
            const float lump = noise::gradient(lumps, 2.3F * std::cos(turn) + 0.31F * static_cast<float>(i),
                                               2.3F * std::sin(turn) + 0.17F * static_cast<float>(i));
            const float r = ring.radius_m + lump_m * lump;
            corners.push_back(ring.middle_m + r * (std::cos(turn) * level + ring.flat * std::sin(turn) * up));
        }
    }
    const auto facet = [&](int a, int b, int c) {
        std::array<glm::vec3, 3> at{corners[a], corners[c], corners[b]};
        std::array<glm::vec3, 3> colours{};
        for (std::size_t i = 0; i < 3; ++i) {
            const float over_m = at[i].y - scene::ground_height_m(land, {at[i].x, at[i].z});
            colours[i] = strata.at(at[i].y, 0.15F) * (0.66F + 0.34F * std::clamp(over_m / 4.0F, 0.0F, 1.0F));
        }
        add_facet(stones.stone, at, colours);
    };
    const auto count = static_cast<int>(rings.size());
    for (int i = 0; i + 1 < count; ++i) {
        for (int side = 0; side < sides; ++side) {
            const int next = (side + 1) % sides;
            const int a = i * sides;
            facet(a + side, a + next, a + sides + side);
            facet(a + next, a + sides + next, a + sides + side);
        }
    }
    for (int side = 1; side + 1 < sides; ++side) {
        facet(0, side + 1, side);
        facet((count - 1) * sides, (count - 1) * sides + side, (count - 1) * sides + side + 1);
    }
}

struct ArchPlace {
    glm::vec2 at_m{0};
    glm::vec2 across{1, 0};  // from foot to foot
    float span_m = 0;
    float height_m = 0;
};

// Whether the ground between lets the viewer see a point.
bool is_in_sight(const scene::Land& land, const glm::vec3& point) {
    const float eye_m = std::max(scene::ground_height_m(land, kViewer_m), 0.0F) + 5.0F;
    for (float share = 0.08F; share < 0.97F; share += 0.06F) {
        const glm::vec2 at = kViewer_m + share * (glm::vec2{point.x, point.z} - kViewer_m);
        if (scene::ground_height_m(land, at) > eye_m + share * (point.y - eye_m)) return false;
    }
    return true;
}

std::optional<ArchPlace> find_arch(const StoneGround& ground, const scene::LandParameters& p,
                                   const std::vector<ArchPlace>& taken, base::Seed seed) {
    const scene::Land& land = ground.land;
    std::optional<ArchPlace> best;
    float most = 0;
    for (std::uint64_t i = 0; i < 160; ++i) {
        base::RandomStream random{seed.child(i)};
        ArchPlace place;
        const float far_m = random.between(90.0F, 430.0F);
        const float aside = random.between(-0.30F, 0.30F);
        place.at_m = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        const float turn = aside + random.between(-0.5F, 0.5F);
        place.across = {std::cos(turn), std::sin(turn)};
        place.height_m = p.arch_height_m * random.between(0.7F, 1.0F) * std::clamp(far_m / 220.0F, 0.55F, 1.0F);
        place.span_m = place.height_m * random.between(0.95F, 1.5F);
        const float half_m = 0.5F * place.span_m + 0.3F * place.height_m;
        if (std::max(std::abs(place.at_m.x), std::abs(place.at_m.y)) > 420.0F) continue;
        const glm::vec2 feet[2] = {place.at_m - half_m * place.across, place.at_m + half_m * place.across};
        float score = 0.5F + 0.4F * random.unit_f();
        const float ground_m = scene::ground_height_m(land, place.at_m);
        bool is_right = is_in_sight(land, {place.at_m.x, ground_m + 0.8F * place.height_m, place.at_m.y});
        for (const glm::vec2& foot : feet) {
            const float foot_m = scene::ground_height_m(land, foot);
            is_right = is_right && foot_m > -2.5F && std::abs(foot_m - ground_m) < 0.55F * place.height_m &&
                       scene::to_road_m(land, foot) > 0.3F * place.height_m;
            // Bare rock bears arches: steep ground, and the shore.
            score += 0.8F * std::min(slope_at(land, foot), 0.9F) + (foot_m < 2.0F ? 0.45F : 0.0F);
        }
        for (const ArchPlace& other : taken) is_right = is_right && glm::length(other.at_m - place.at_m) > 70.0F;
        if (!is_right || score <= most) continue;
        most = score;
        best = place;
    }
    return best;
}

void add_arch(Stones& stones, const StoneGround& ground, const ArchPlace& place, const Strata& strata,
              base::Seed seed) {
    const scene::Land& land = ground.land;
    base::RandomStream random{seed};
    const float thick_m = place.height_m * random.between(0.16F, 0.22F);
    const float lean = random.between(-0.18F, 0.18F);
    const auto ground_m = [&](float along_m) {
        return scene::ground_height_m(land, place.at_m + along_m * place.across);
    };
    const float half_m = 0.5F * place.span_m;
    const float foot_left_m = ground_m(-half_m) - 0.35F * place.height_m;
    const float foot_right_m = ground_m(half_m) - 0.35F * place.height_m;
    const float top_m = std::max(ground_m(-half_m), ground_m(half_m)) + place.height_m - thick_m;
    constexpr int kRings = 22;
    std::vector<Ring> rings;
    for (int i = 0; i < kRings; ++i) {
        const float t = static_cast<float>(i) / (kRings - 1);
        // A flat-topped curve whose feet stand nearly upright and widen.
        const float angle = kPi * t;
        const float x = -std::cos(angle) * half_m * (1.0F + 0.28F * (1.0F - std::sin(angle)));
        const float rise = std::pow(std::max(std::sin(angle), 0.0F), 0.62F);
        const float foot_m = foot_left_m + t * (foot_right_m - foot_left_m);
        const float stout = 1.0F + 1.1F * std::pow(1.0F - std::sin(angle), 2.2F);
        const glm::vec2 at = place.at_m + x * place.across +
                             lean * thick_m * std::sin(2 * angle) * glm::vec2{-place.across.y, place.across.x};
        rings.push_back({{at.x, foot_m + rise * (top_m - foot_m), at.y}, {}, thick_m * stout, 0.85F});
    }
    for (std::size_t i = 0; i < rings.size(); ++i)
        rings[i].along =
            glm::normalize(rings[std::min(i + 1, rings.size() - 1)].middle_m - rings[i > 0 ? i - 1 : 0].middle_m);
    add_tube(stones, rings, 11, 0.5F * thick_m, noise::Key{seed.child("lumps")}, strata, land);
    for (const float side : {-1.0F, 1.0F})
        stones.footprints.push_back({place.at_m + side * half_m * 1.2F * place.across, 1.9F * thick_m});
    // What has fallen from it.
    for (int i = 0; i < 7; ++i) {
        const float ahead_m = random.between(-0.5F, 0.5F) * place.height_m;
        const float aside_m = random.between(-0.9F, 0.9F) * place.span_m;
        const glm::vec2 at = place.at_m + aside_m * place.across + ahead_m * glm::vec2{-place.across.y, place.across.x};
        if (scene::to_road_m(land, at) < 3.0F) continue;
        add_boulder(stones, strata, {at.x, scene::ground_height_m(land, at), at.y},
                    place.height_m * random.between(0.03F, 0.10F), random);
    }
}

// A porch of rock before a steep slope, dark inside.
void add_cave(Stones& stones, const StoneGround& ground, glm::vec2 at_m, float radius_m, const Strata& strata,
              base::Seed seed) {
    const scene::Land& land = ground.land;
    const glm::vec3 n = scene::ground_normal(land, at_m);
    const glm::vec2 down = glm::normalize(glm::vec2{n.x, n.z} + glm::vec2{1.0e-5F, 0});
    const glm::vec2 aside{-down.y, down.x};
    base::RandomStream random{seed};
    constexpr int kSides = 11;  // of the vault, from foot to foot
    const float floor_m = scene::ground_height_m(land, at_m + 0.6F * radius_m * down);
    const auto vault = [&](float out_m, float r, int side) {
        const float turn = kPi * static_cast<float>(side) / (kSides - 1);
        const glm::vec2 at = at_m + out_m * down - std::cos(turn) * r * aside;
        return glm::vec3{at.x, floor_m - 1.0F + std::sin(turn) * 1.15F * r, at.y};
    };
    std::vector<float> lumps(kSides);
    for (float& lump : lumps) lump = random.between(0.88F, 1.14F);
    const auto quads = [&](const auto& from, const auto& to, float shade_from, float shade_to) {
        for (int side = 0; side + 1 < kSides; ++side) {
            const glm::vec3 a = from(side), b = from(side + 1), c = to(side), d = to(side + 1);
            const auto colour = [&](const glm::vec3& at, float shade) { return shade * strata.at(at.y, 0.15F); };
            add_facet(stones.stone, {a, c, b}, {colour(a, shade_from), colour(c, shade_to), colour(b, shade_from)});
            add_facet(stones.stone, {b, c, d}, {colour(b, shade_from), colour(c, shade_to), colour(d, shade_to)});
        }
    };
    const auto outer_back = [&](int s) { return vault(-1.3F * radius_m, 1.25F * radius_m * lumps[s], s); };
    const auto outer_lip = [&](int s) { return vault(0.75F * radius_m * lumps[s], 1.12F * radius_m * lumps[s], s); };
    const auto inner_lip = [&](int s) { return vault(0.62F * radius_m * lumps[s], 0.74F * radius_m * lumps[s], s); };
    const auto inner_back = [&](int s) { return vault(-0.25F * radius_m, 0.52F * radius_m, s); };
    const auto end = [&](int) { return vault(-0.35F * radius_m, 0.0F, 0); };
    quads(outer_lip, outer_back, 0.95F, 0.8F);
    quads(inner_lip, outer_lip, 0.6F, 0.95F);
    quads(inner_back, inner_lip, 0.07F, 0.6F);
    quads(end, inner_back, 0.03F, 0.07F);
    // What stands in the hill and in the ground: it closes the mesh and is never seen.
    const glm::vec3 dark{0.02F};
    const glm::vec3 behind = vault(-1.3F * radius_m, 0, 0);
    for (int side = 0; side + 1 < kSides; ++side)
        add_facet(stones.stone, {behind, outer_back(side + 1), outer_back(side)}, {dark, dark, dark});
    for (const int side : {0, kSides - 1}) {
        const std::array<glm::vec3, 6> foot{behind,          outer_back(side), outer_lip(side),
                                            inner_lip(side), inner_back(side), end(side)};
        for (std::size_t i = 1; i + 1 < foot.size(); ++i) {
            if (side == 0)
                add_facet(stones.stone, {foot[0], foot[i], foot[i + 1]}, {dark, dark, dark});
            else
                add_facet(stones.stone, {foot[0], foot[i + 1], foot[i]}, {dark, dark, dark});
        }
    }
    stones.footprints.push_back({at_m + 0.5F * radius_m * down, 1.3F * radius_m});
}

void add_caves(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
               base::Seed seed) {
    const scene::Land& land = ground.land;
    std::vector<glm::vec2> caves;
    for (std::uint64_t i = 0; i < 260 && caves.size() < 2; ++i) {
        base::RandomStream random{seed.child(i)};
        const float far_m = random.between(70.0F, 330.0F);
        const float aside = random.between(-0.33F, 0.33F);
        const glm::vec2 at = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        const float radius_m = p.arch_height_m * random.between(0.22F, 0.34F);
        const glm::vec3 n = scene::ground_normal(land, at);
        const float height_m = scene::ground_height_m(land, at);
        const bool faces_viewer =
            glm::dot(glm::vec2{n.x, n.z}, kViewer_m - at) > 0.35F * glm::length(kViewer_m - at) * (1 - n.y * n.y);
        if (slope_at(land, at) < 0.55F || !faces_viewer || height_m < 1.0F || std::abs(at.x) > 420.0F) continue;
        if (scene::to_road_m(land, at) < 2.0F * radius_m || scene::water_depth_m(land, at) > 0) continue;
        if (!is_in_sight(land, {at.x, height_m + radius_m, at.y})) continue;
        bool is_apart = true;
        for (const glm::vec2& other : caves) is_apart = is_apart && glm::length(other - at) > 60.0F;
        if (!is_apart) continue;
        add_cave(stones, ground, at, radius_m, strata, seed.child(i));
        caves.push_back(at);
    }
}

}  // namespace

void add_arches(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                base::Seed seed) {
    const std::uint64_t count = p.arch_share > 0.6F ? 2 : 1;
    std::vector<ArchPlace> arches;
    for (std::uint64_t i = 0; i < count; ++i) {
        const base::Seed own = seed.child("arch").child(i);
        const auto place = find_arch(ground, p, arches, own);
        if (!place) continue;
        add_arch(stones, ground, *place, strata, own);
        arches.push_back(*place);
    }
    add_caves(stones, ground, p, strata, seed.child("caves"));
}

}  // namespace quadrat::synthesis::land
