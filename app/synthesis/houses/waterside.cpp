// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/waterside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/houses/masses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kFarthest_m = 170;  // from the middle
constexpr float kDeep_m = 0.7F;     // under a boat
constexpr float kOverWater_m = 0.55F;
constexpr float kJetty_m = 13;
constexpr float kApart_m = 30;

struct Berth {
    glm::vec2 shore_m{0};
    glm::vec2 out{0, 1};
    float surface_m = 0;
};

glm::vec2 bearing(int i, int of) {
    const float turn = 6.2831853F * static_cast<float>(i) / static_cast<float>(of);
    return {std::sin(turn), std::cos(turn)};
}

// Where the ground falls away into deep water on a straight way out from the shore.
std::optional<Berth> berth_at(const scene::Land& land, glm::vec2 at) {
    if (scene::water_depth_m(land, at) > 0) return std::nullopt;
    for (int i = 0; i < 16; ++i) {
        const glm::vec2 out = bearing(i, 16);
        const float far_m = scene::water_depth_m(land, at + kJetty_m * out);
        if (far_m < kDeep_m || scene::water_depth_m(land, at + 4.0F * out) <= 0.1F ||
            scene::water_depth_m(land, at + 8.0F * out) < 0.5F)
            continue;
        const glm::vec2 end = at + kJetty_m * out;
        const float surface_m = std::max(scene::ground_height_m(land, end), -50.0F) + far_m;
        if (scene::ground_height_m(land, at) - surface_m > 1.6F) continue;
        return Berth{at, out, surface_m};
    }
    return std::nullopt;
}

std::vector<Berth> berths(const scene::Land& land, const Settled& settled, std::size_t most) {
    std::vector<Berth> found;
    for (float r = 10; r < kFarthest_m && found.size() < most; r += 4) {
        const int steps = static_cast<int>(r);
        for (int i = 0; i < steps && found.size() < most; ++i) {
            const glm::vec2 at = settled.middle_m + r * bearing(i, steps);
            if (std::max(std::abs(at.x), std::abs(at.y)) > 0.5F * land.side_m() - 60) continue;
            const bool is_apart =
                std::ranges::all_of(found, [at](const Berth& b) { return glm::distance(b.shore_m, at) > kApart_m; });
            const bool is_free = std::ranges::all_of(settled.settlement.houses, [&](const scene::House& house) {
                const glm::vec2 off = at - glm::vec2{house.foot_m.x, house.foot_m.z};
                if (glm::dot(off, off) > 900) return true;
                return scene::to_house_m(settled.settlement.buildings[house.building], house, at) > 3;
            });
            if (!is_apart || !is_free) continue;
            if (const auto berth = berth_at(land, at)) found.push_back(*berth);
        }
    }
    return found;
}

void add_deck(scene::Masses& to, const Berth& berth, float length_m) {
    const Look planks{scene::linear_from_srgb_hex(0x8B7A63), scene::Cladding::Planks, 0};
    const Look posts{scene::linear_from_srgb_hex(0x5A4B3A), scene::Cladding::Plain, 0};
    const glm::vec3 along{berth.out.x, 0, berth.out.y};
    const glm::vec3 side{-berth.out.y, 0, berth.out.x};
    const glm::vec3 from{berth.shore_m.x, berth.surface_m + kOverWater_m - 0.14F, berth.shore_m.y};
    const glm::vec3 middle = from + along * (0.5F * length_m - 1);
    add_box(to, {middle, along, {0.5F * length_m + 1, 0.14F, 0.85F}}, planks, 0.7F);
    for (float at = 2; at < length_m; at += 3)
        for (const float s : {-0.85F, 0.85F})
            add_box(to, {from + along * at + side * s - glm::vec3{0, 2.6F, 0}, along, {0.09F, 3.3F, 0.09F}}, posts);
}

// A rowing boat: two bent sides, a transom, a bench, seen from outside and inside.
void add_boat(scene::Masses& to, const glm::vec3& middle, const glm::vec3& along, const glm::vec3& colour) {
    const glm::vec3 side{-along.z, 0, along.x};
    const glm::vec3 up{0, 1, 0};
    constexpr std::array<float, 4> kStations{-2.0F, -0.9F, 0.7F, 2.2F};
    constexpr std::array<float, 4> kHalf{0.52F, 0.72F, 0.66F, 0.03F};
    constexpr std::array<float, 4> kRim{0.42F, 0.38F, 0.42F, 0.68F};
    const auto at = [&](std::size_t i, float s, float high) {
        const float narrow = high < 0 ? 0.6F : 1.0F;
        return middle + along * kStations[i] + side * (s * narrow * kHalf[i]) + up * high;
    };
    const Look hull{colour, scene::Cladding::Boards, 0};
    const Look inner{scene::linear_from_srgb_hex(0x9A8468), scene::Cladding::Boards, 0};
    for (std::size_t i = 0; i + 1 < kStations.size(); ++i)
        for (const float s : {1.0F, -1.0F}) {
            std::array out{at(i, s, -0.25F), at(i + 1, s, -0.25F), at(i + 1, s, kRim[i + 1]), at(i, s, kRim[i])};
            std::array in{out[3], out[2], out[1], out[0]};
            if (s < 0) std::swap(out, in);
            add_face(to, in, hull);
            add_face(to, out, inner);
        }
    add_face(to, std::array{at(0, 1, -0.25F), at(0, -1, -0.25F), at(0, -1, kRim[0]), at(0, 1, kRim[0])}, hull);
    add_face(to, std::array{at(0, -1, -0.25F), at(0, 1, -0.25F), at(0, 1, kRim[0]), at(0, -1, kRim[0])}, inner);
    for (std::size_t i = 0; i + 1 < kStations.size(); ++i)
        add_face(to, std::array{at(i, 1, 0.06F), at(i + 1, 1, 0.06F), at(i + 1, -1, 0.06F), at(i, -1, 0.06F)}, inner);
    add_box(to, {middle + up * 0.2F, side, {0.64F, 0.05F, 0.13F}}, inner);
}

}  // namespace

std::vector<scene::Masses> add_jetties(const scene::Land& land, const Settled& settled,
                                       const scene::LandParameters& parameters, base::Seed seed) {
    constexpr std::array<std::uint32_t, 5> kHulls{0xD9D4C6, 0x2F5F86, 0x8E3B2F, 0x3F6B50, 0xC9A03C};
    std::vector<scene::Masses> all;
    if (parameters.settle_by_water < 0.3F) return all;
    const auto most =
        static_cast<std::size_t>(1 + parameters.settle_by_water * 3 * std::max(parameters.settle_age, 0.0F));
    const std::vector<Berth> found = berths(land, settled, most);
    for (std::size_t i = 0; i < found.size(); ++i) {
        base::RandomStream random{seed.child(i)};
        const Berth& berth = found[i];
        scene::Masses piece;
        add_deck(piece, berth, kJetty_m);
        const glm::vec3 out{berth.out.x, 0, berth.out.y};
        const glm::vec3 side{-out.z, 0, out.x};
        const std::uint32_t boats = 1 + random.below(3);
        for (std::uint32_t k = 0; k < boats; ++k) {
            const float s = k % 2 == 0 ? 1.0F : -1.0F;
            const float along_m = kJetty_m - 2.4F - 4.6F * static_cast<float>(k / 2) - random.between(0, 1);
            const glm::vec3 at = glm::vec3{berth.shore_m.x, berth.surface_m, berth.shore_m.y} + along_m * out +
                                 s * random.between(1.75F, 2.0F) * side;
            if (scene::water_depth_m(land, {at.x, at.z}) < 0.4F) continue;
            const float turn = random.between(-0.12F, 0.12F);
            const glm::vec3 along = glm::normalize(out + turn * side);
            add_boat(piece, at, random.unit() < 0.5 ? along : -along,
                     scene::linear_from_srgb_hex(kHulls[random.below(kHulls.size())]));
        }
        all.push_back(std::move(piece));
    }
    return all;
}

}  // namespace quadrat::synthesis::houses
