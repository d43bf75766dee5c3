// SPDX-License-Identifier: Apache-2.0
// What no heightfield can hold (Peytavie et al., "Arches: a framework for modeling complex terrains", 2009), as meshes
// of their own: an outcrop of rock stands out of a slope, and in its front there is a mouth, dark inside. It stands so
// far before the slope that the ground within the mouth is level; what closes the mesh lies in the hill.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "scene/land_parameters.hpp"
#include "synthesis/land/facets.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLip = 1.45F;  // how far before its place in the slope the mouth opens, in its radii

struct CavePlace {
    glm::vec2 at_m{0};  // in the slope
    glm::vec2 down{0, 1};
    float radius_m = 6;  // half the mouth's breadth, about
    float floor_m = 0;

    glm::vec2 at(float out, float aside) const {
        return at_m + radius_m * (out * down + aside * glm::vec2{-down.y, down.x});
    }
};

// The slope over the breadth of a cave: rise over run, and which way is down.
struct Fall {
    float slope;
    glm::vec2 down;
};

Fall fall_at(const scene::Land& land, glm::vec2 at_m, float reach_m) {
    const auto height_m = [&](float x, float z) { return scene::ground_height_m(land, at_m + glm::vec2{x, z}); };
    const glm::vec2 rise =
        glm::vec2{height_m(reach_m, 0) - height_m(-reach_m, 0), height_m(0, reach_m) - height_m(0, -reach_m)} /
        (2 * reach_m);
    const float slope = glm::length(rise);
    return {slope, -rise / std::max(slope, 1.0e-5F)};
}

struct HoopShape {
    float out;      // before its place in the slope, in radii
    float breadth;  // half, in radii
    float height;   // in radii
    float lump;     // how far chance moves it, in radii
};
// From the back of the hollow out to the lip, over the brow and back into the hill.
constexpr std::array<HoopShape, 7> kShapes{{{0.55F, 0.55F, 0.50F, 0.10F},
                                            {1.05F, 0.80F, 0.86F, 0.22F},
                                            {1.40F, 0.92F, 1.02F, 0.30F},
                                            {1.50F, 1.22F, 1.32F, 0.30F},
                                            {1.25F, 1.75F, 1.80F, 0.40F},
                                            {0.35F, 2.15F, 2.10F, 0.45F},
                                            {-1.60F, 2.30F, 1.90F, 0.30F}}};
constexpr std::size_t kBrow = 3;  // from there on it is the rock's outside
constexpr float kSole = -1.0F;    // how deep the feet reach under the mouth's floor, in radii

// Whether the hill closes around the rock: it rises behind it, and beside it the ground hides the soles.
bool is_in_the_hill(const scene::Land& land, const CavePlace& place) {
    const auto rise = [&](float out, float aside) {
        return (scene::ground_height_m(land, place.at(out, aside)) - place.floor_m) / place.radius_m;
    };
    bool is_closed = rise(kShapes.back().out, 0) > 0.7F;
    constexpr float kLowest = -0.4F;  // of the ground beside it: the soles lie well under that
    for (std::size_t i = kBrow; i < kShapes.size(); ++i) {
        const float between = 0.5F * (kShapes[i].out + kShapes[i - 1].out);
        for (const float side : {-1.35F, -1.0F, 1.0F, 1.35F})  // chance moves the feet
            is_closed = is_closed && rise(kShapes[i].out, side * kShapes[i].breadth) > kLowest &&
                        rise(between, side * kShapes[i].breadth) > kLowest;
    }
    return is_closed;
}

// Steep, near, turned to the viewer, dry, and with a level step before it.
std::optional<CavePlace> find_cave(const scene::Land& land, const scene::LandParameters& p,
                                   const std::vector<CavePlace>& taken, base::Seed seed) {
    std::optional<CavePlace> best;
    float most = 0;
    for (std::uint64_t i = 0; i < 1200; ++i) {
        base::RandomStream random{seed.child(i)};
        const float far_m = random.between(60.0F, 300.0F);
        const float aside = random.between(-0.6F, 0.6F);
        CavePlace place;
        place.at_m = kViewer_m + far_m * glm::vec2{std::sin(aside), -std::cos(aside)};
        place.radius_m = std::clamp(p.arch_height_m * random.between(0.26F, 0.38F), 3.6F, 10.0F);
        if (std::max(std::abs(place.at_m.x), std::abs(place.at_m.y)) > 400.0F) continue;
        const Fall fall = fall_at(land, place.at_m, place.radius_m);
        const glm::vec2 to_viewer = glm::normalize(kViewer_m - place.at_m);
        const float turned = glm::dot(fall.down, to_viewer);
        if (fall.slope < 0.34F || turned < 0.35F) continue;
        // Toward the viewer a little: a mouth seen from its side is none.
        place.down = glm::normalize(fall.down + 0.5F * to_viewer);
        const glm::vec2 court = place.at(kLip + 0.6F, 0);
        place.floor_m = scene::ground_height_m(land, place.at(kLip - 0.1F, 0));
        const float before_m = scene::ground_height_m(land, court);
        if (before_m < 0.8F || scene::water_depth_m(land, court) > 0 || scene::water_depth_m(land, place.at_m) > 0)
            continue;
        if (scene::to_road_m(land, court) < 2.2F * place.radius_m || !is_in_the_hill(land, place)) continue;
        const bool is_apart = std::ranges::none_of(
            taken, [&](const CavePlace& other) { return glm::length(other.at_m - place.at_m) < 60.0F; });
        if (!is_apart) continue;
        const glm::vec2 mouth = place.at(kLip, 0);
        const bool is_seen = is_in_sight(land, {mouth.x, place.floor_m + place.radius_m, mouth.y});
        const float score = std::min(fall.slope, 1.1F) + 0.5F * turned + 0.09F * place.radius_m - 0.0025F * far_m +
                            (is_seen ? 0.9F : 0.0F);
        if (score <= most) continue;
        most = score;
        best = place;
    }
    return best;
}

// A line from foot to foot over the cave, so many corners; the first and the last lie deep in the ground.
constexpr int kCorners = 15;
using Hoop = std::array<glm::vec3, kCorners>;

Hoop hoop_of(const CavePlace& place, const HoopShape& shape, noise::Key lumps) {
    Hoop hoop;
    for (int i = 0; i < kCorners; ++i) {
        const bool is_foot = i == 0 || i == kCorners - 1;
        const float turn = kPi * static_cast<float>(std::clamp(i, 1, kCorners - 2) - 1) / (kCorners - 3);
        const float x = -std::cos(turn);
        const float y = std::pow(std::max(std::sin(turn), 0.0F), 0.75F);
        // The same for a foot as for the corner over it.
        const float lump =
            shape.lump * noise::gradient(lumps, 2.1F * x + 1.7F * shape.out, 2.1F * y + 0.9F * shape.out);
        const float push = 1 + lump;
        const glm::vec2 at = place.at(shape.out + 0.5F * lump, push * shape.breadth * x);
        const float up = is_foot ? kSole : push * shape.height * y - 0.02F;
        hoop[static_cast<std::size_t>(i)] = {at.x, place.floor_m + place.radius_m * up, at.y};
    }
    return hoop;
}

class CaveMesh {
  public:
    CaveMesh(Stones& stones, const Strata& strata) : stones_(stones), strata_(strata) {}

    // Between two lines; shades from the first to the second.
    void span(const Hoop& a, const Hoop& b, float shade_a, float shade_b) {
        for (std::size_t i = 0; i + 1 < kCorners; ++i) {
            facet({a[i], b[i], a[i + 1]}, {shade_a, shade_b, shade_a});
            facet({a[i + 1], b[i], b[i + 1]}, {shade_a, shade_b, shade_b});
        }
    }
    // From a line to one point: closes the mesh at the back of the hollow and in the hill.
    void close(const Hoop& a, const glm::vec3& to, bool is_front, float shade) {
        for (std::size_t i = 0; i + 1 < kCorners; ++i)
            is_front ? facet({a[i], a[i + 1], to}, {shade, shade, shade})
                     : facet({a[i], to, a[i + 1]}, {shade, shade, shade});
    }
    // The soles, deep in the ground: along the feet of all lines, and between the two ends.
    void sole(const std::vector<glm::vec3>& left, const std::vector<glm::vec3>& right) {
        for (std::size_t i = 0; i + 1 < left.size(); ++i) {
            facet({left[i], right[i], left[i + 1]}, {0.1F, 0.1F, 0.1F});
            facet({left[i + 1], right[i], right[i + 1]}, {0.1F, 0.1F, 0.1F});
        }
    }

  private:
    void facet(const std::array<glm::vec3, 3>& at, const std::array<float, 3>& shades) {
        std::array<glm::vec3, 3> colours{};
        for (std::size_t i = 0; i < 3; ++i) colours[i] = shades[i] * strata_.at(at[i].y, 0.15F);
        add_facet(stones_.stone, at, colours);
    }
    Stones& stones_;
    const Strata& strata_;
};

void add_cave(Stones& stones, const StoneGround& ground, const CavePlace& place, const Strata& strata,
              base::Seed seed) {
    const noise::Key lumps{seed.child("lumps")};
    constexpr std::array<float, 7> kShades{0.012F, 0.05F, 0.5F, 0.92F, 1.0F, 0.95F, 0.85F};
    std::array<Hoop, kShapes.size()> hoops;
    for (std::size_t i = 0; i < hoops.size(); ++i) {
        HoopShape shape = kShapes[i];
        // The last lies in the hill.
        const glm::vec2 at = place.at(shape.out, 0);
        if (i + 1 == hoops.size())
            shape.height = std::clamp((scene::ground_height_m(ground.land, at) - place.floor_m) / place.radius_m - 0.4F,
                                      0.1F, 1.9F);
        hoops[i] = hoop_of(place, shape, lumps);
    }
    const std::size_t first = stones.stone.mesh.positions_m.size();
    CaveMesh mesh(stones, strata);
    const auto ahead = [&](float out, float up) {
        const glm::vec2 at = place.at(out, 0);
        return glm::vec3{at.x, place.floor_m + place.radius_m * up, at.y};
    };
    std::vector<glm::vec3> left{ahead(0.4F, kSole)};
    std::vector<glm::vec3> right = left;
    for (std::size_t i = 0; i < hoops.size(); ++i) {
        if (i > 0) mesh.span(hoops[i - 1], hoops[i], kShades[i - 1], kShades[i]);
        left.push_back(hoops[i].front());
        right.push_back(hoops[i].back());
    }
    mesh.close(hoops.front(), ahead(0.4F, kSole), true, 0.01F);
    mesh.close(hoops.back(), ahead(-1.7F, kSole), false, 0.8F);
    left.push_back(ahead(-1.7F, kSole));
    right.push_back(left.back());
    mesh.sole(left, right);
    round_off(stones.stone, first, 0.8F);
    // What has fallen from the brow lies at both sides of the way in.
    base::RandomStream random{seed.child("fallen")};
    for (int i = 0; i < 8; ++i) {
        const float side = i % 2 == 0 ? -1.0F : 1.0F;
        const glm::vec2 at = place.at(random.between(1.5F, 2.5F), side * random.between(0.85F, 2.0F));
        add_boulder(stones, strata, {at.x, scene::ground_height_m(ground.land, at), at.y},
                    place.radius_m * random.between(0.08F, 0.34F), random);
    }
    const glm::vec2 mouth = place.at(kLip + 0.35F, 0);
    stones.landmarks.push_back(
        {{mouth.x, place.floor_m + 0.7F * place.radius_m, mouth.y}, place.down, 3.2F * place.radius_m, true});
    stones.footprints.push_back({place.at(0.9F, 0), 1.9F * place.radius_m});
    stones.forecourts.push_back({place.at(2.4F, 0), 2.0F * place.radius_m});
}

}  // namespace

void add_caves(Stones& stones, const StoneGround& ground, const scene::LandParameters& p, const Strata& strata,
               base::Seed seed) {
    const std::uint64_t most = p.arch_share > 0.5F ? 2 : 1;
    std::vector<CavePlace> caves;
    for (std::uint64_t i = 0; i < most; ++i) {
        const base::Seed own = seed.child(i);
        const auto place = find_cave(ground.land, p, caves, own);
        if (!place) break;
        add_cave(stones, ground, *place, strata, own);
        caves.push_back(*place);
    }
}

}  // namespace quadrat::synthesis::land
