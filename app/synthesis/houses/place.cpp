// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/land_parameters.hpp"
#include "synthesis/houses/lanes.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr glm::vec2 kViewer_m{0, 290};
constexpr float kSteepest = 0.26F;  // of the ground about the middle

std::array<glm::vec2, 8> around(float radius_m) {
    std::array<glm::vec2, 8> ring;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const float turn = 0.785398F * static_cast<float>(i);
        ring[i] = radius_m * glm::vec2{std::sin(turn), std::cos(turn)};
    }
    return ring;
}

// How far the ground between the viewer and the place stands over the line of sight.
float hidden_m(const scene::Land& land, glm::vec2 at) {
    const float from_m = std::max(scene::ground_height_m(land, kViewer_m), 0.0F) + 4;
    const float to_m = scene::ground_height_m(land, at) + 3;
    float most = 0;
    for (int i = 2; i < 19; ++i) {
        const float t = static_cast<float>(i) / 20;
        const float over =
            scene::ground_height_m(land, kViewer_m + t * (at - kViewer_m)) - (from_m + t * (to_m - from_m));
        most = std::max(most, over);
    }
    return most;
}

float to_roads_m(const scene::Land& land, glm::vec2 at) {
    float least = 120;
    for (const scene::Road& road : land.roads)
        for (const glm::vec3& p : road.line_m) least = std::min(least, glm::distance(glm::vec2{p.x, p.z}, at));
    return least;
}

// Of living here; the less the better. None: unfit, or not below the most that is asked for.
std::optional<float> price_of(const scene::Land& land, const scene::LandParameters& p, glm::vec2 at, float most) {
    if (!is_buildable(land, at)) return std::nullopt;
    float steep = 0;
    int dry = 0;
    for (const glm::vec2 off : around(22)) {
        if (!is_buildable(land, at + off)) continue;
        steep += steepness(land, at + off, 8) / 8;
        ++dry;
    }
    if (dry < 6 || steep > kSteepest) return std::nullopt;
    const float here_m = scene::ground_height_m(land, at);
    float around_m = 0;
    for (const glm::vec2 off : around(90)) around_m += std::max(scene::ground_height_m(land, at + off), 0.0F) / 8;
    const float over = std::clamp((here_m - around_m) / 14, -1.0F, 1.0F);
    const float slope_south =
        scene::ground_height_m(land, at - glm::vec2{0, 15}) - scene::ground_height_m(land, at + glm::vec2{0, 15});
    const float sun = std::clamp(slope_south / 5, -1.0F, 1.0F);
    const glm::vec2 off = glm::vec2{at.x, at.y - 125} / glm::vec2{150, 110};
    float price = 10 * steep - (2.4F * p.settle_on_height - 0.6F) * over - 0.35F * sun + 0.55F * glm::dot(off, off);
    // What is left to add is dear to find and never less than 0.
    if (price >= most) return std::nullopt;
    price += 0.7F * to_roads_m(land, at) / 120 + 0.25F * std::min(hidden_m(land, at), 8.0F);
    if (price >= most) return std::nullopt;
    return price + p.settle_by_water * 2.4F * std::abs(to_water_m(land, at) - 28) / 130;
}

}  // namespace

float to_water_m(const scene::Land& land, glm::vec2 at_m, float most_m) {
    for (float r = 8; r < most_m; r += 10) {
        const int steps = std::max(8, static_cast<int>(r / 3));
        for (int i = 0; i < steps; ++i) {
            const float turn = 6.2831853F * static_cast<float>(i) / static_cast<float>(steps);
            if (scene::water_depth_m(land, at_m + r * glm::vec2{std::sin(turn), std::cos(turn)}) > 0) return r;
        }
    }
    return most_m;
}

std::optional<glm::vec2> settling_place(const scene::Land& land, const scene::LandParameters& parameters) {
    if (land.site) return glm::vec2{land.site->middle_m.x, land.site->middle_m.z};
    std::optional<glm::vec2> best;
    float least = 1.0e9F;
    for (float z = -160; z <= 200; z += 15) {
        for (float x = -225; x <= 225; x += 15) {
            const std::optional<float> price = price_of(land, parameters, {x, z}, least);
            if (!price || *price >= least) continue;
            least = *price;
            best = glm::vec2{x, z};
        }
    }
    return best;
}

}  // namespace quadrat::synthesis::houses
