// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <span>

#include "scene/land_parameters.hpp"
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
            const float along = 22 * static_cast<float>(i) / static_cast<float>(rings.size());
            const auto lumps_of = [&](float size) {
                return noise::gradient(lumps, size * (2.3F * std::cos(turn) + 0.31F * along),
                                       size * (2.3F * std::sin(turn) + 0.17F * along));
            };
            const float lump = lumps_of(1) + 0.35F * lumps_of(2.9F);
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

// is_choosy: in the viewer's sight, its feet at like heights. Rugged land has no such place: any that bears one will
// do.
std::optional<ArchPlace> find_arch(const StoneGround& ground, const scene::LandParameters& p,
                                   std::span<const scene::Landmark> taken, base::Seed seed, bool is_choosy) {
    const scene::Land& land = ground.land;
    const float uneven = is_choosy ? 0.55F : 0.95F;  // of its height, between a foot and the middle
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
        bool is_right = !is_choosy || is_in_sight(land, {place.at_m.x, ground_m + 0.8F * place.height_m, place.at_m.y});
        for (const glm::vec2& foot : feet) {
            const float foot_m = scene::ground_height_m(land, foot);
            is_right = is_right && foot_m > -2.5F && std::abs(foot_m - ground_m) < uneven * place.height_m &&
                       scene::to_road_m(land, foot) > 0.3F * place.height_m;
            // Bare rock bears arches: steep ground, and the shore.
            score += 0.8F * std::min(slope_at(land, foot), 0.9F) + (foot_m < 2.0F ? 0.45F : 0.0F);
        }
        for (const scene::Landmark& other : taken) {
            const float apart_m = other.has_front ? 1.8F * other.size_m + half_m : 70.0F;
            is_right = is_right && glm::length(glm::vec2{other.at_m.x, other.at_m.z} - place.at_m) > apart_m;
        }
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
    constexpr int kRings = 40;
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
    const std::size_t first = stones.stone.mesh.positions_m.size();
    add_tube(stones, rings, 16, 0.5F * thick_m, noise::Key{seed.child("lumps")}, strata, land);
    round_off(stones.stone, first, 0.75F);
    // From the side of it that the viewer is on.
    const glm::vec2 through{-place.across.y, place.across.x};
    const float toward = glm::dot(through, kViewer_m - place.at_m) < 0 ? -1.0F : 1.0F;
    stones.landmarks.push_back({{place.at_m.x, top_m - 0.3F * place.height_m, place.at_m.y},
                                toward * through,
                                std::max(place.height_m, place.span_m)});
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

}  // namespace

void add_arches(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
                base::Seed seed) {
    const std::uint64_t count = p.arch_share > 0.6F ? 2 : 1;
    for (std::uint64_t i = 0; i < count; ++i) {
        const base::Seed own = seed.child("arch").child(i);
        auto place = find_arch(ground, p, stones.landmarks, own, true);
        if (!place) place = find_arch(ground, p, stones.landmarks, own, false);
        if (!place) continue;
        add_arch(stones, ground, *place, strata, own);
    }
}

}  // namespace quadrat::synthesis::land
