// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "synthesis/land/facets.hpp"

namespace quadrat::synthesis::land {
namespace {

// A hewn block: a box whose corners chance has moved.
struct Block {
    glm::vec3 foot_m;    // the middle of its lower side
    glm::vec2 across;    // unit, its breadth's way
    glm::vec3 size_m;    // breadth, height, depth
    float taper = 0.8F;  // breadth of its top to that of its foot
};

void add_block(Stones& stones, const Strata& strata, const Block& block, base::RandomStream& random) {
    const glm::vec3 across{block.across.x, 0, block.across.y};
    const glm::vec3 deep{-block.across.y, 0, block.across.x};
    const float tint = random.between(0.86F, 1.1F);
    std::array<glm::vec3, 8> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool is_top = i >= 4;
        const float narrow = is_top ? block.taper : 1.0F;
        const float a = (i % 2 == 0 ? -0.5F : 0.5F) * narrow * random.between(0.86F, 1.1F);
        const float d = ((i / 2) % 2 == 0 ? -0.5F : 0.5F) * narrow * random.between(0.86F, 1.1F);
        const float up = is_top ? block.size_m.y * random.between(0.92F, 1.03F) : 0.0F;
        corners[i] = block.foot_m + a * block.size_m.x * across + d * block.size_m.z * deep + glm::vec3{0, up, 0};
    }
    const auto quad = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        const auto colour = [&](std::size_t i) {
            const float up = (corners[i].y - block.foot_m.y) / std::max(block.size_m.y, 0.1F);
            return strata.at(corners[i].y, tint) * tint * (0.7F + 0.3F * std::clamp(up, 0.0F, 1.0F));
        };
        add_facet(stones.stone, {corners[a], corners[b], corners[c]}, {colour(a), colour(b), colour(c)});
        add_facet(stones.stone, {corners[a], corners[c], corners[d]}, {colour(a), colour(c), colour(d)});
    };
    quad(4, 6, 7, 5);  // top
    quad(0, 1, 3, 2);  // foot
    quad(0, 4, 5, 1);
    quad(2, 3, 7, 6);
    quad(0, 2, 6, 4);
    quad(1, 5, 7, 3);
}

// From the edge of the nearest road: to_road_m() counts the site's own ground as kept clear, and stones stand on it.
float past_roads_m(const scene::Land& land, glm::vec2 at_m) {
    float least_m = scene::kFarFromRoads_m;
    for (const scene::Road& road : land.roads)
        for (const glm::vec3& point_m : road.line_m)
            least_m = std::min(least_m, glm::length(glm::vec2{point_m.x, point_m.z} - at_m) - 0.5F * road.width_m);
    return least_m;
}

}  // namespace

void add_standing_stones(Stones& stones, const scene::Land& land, const Strata& strata, base::Seed seed) {
    if (!land.site || !land.settlement.is_empty()) return;
    base::RandomStream random{seed};
    const glm::vec2 middle{land.site->middle_m.x, land.site->middle_m.z};
    const float reach_m = 0.55F * land.site->radius_m;
    const int count = 9 + static_cast<int>(random.below(6));
    const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(count);
    const float tall_m = random.between(4.2F, 6.4F);
    const glm::vec2 to_viewer = kViewer_m - middle;
    stones.landmarks.push_back({land.site->middle_m + glm::vec3{0, 0.5F * tall_m, 0},
                                to_viewer / std::max(glm::length(to_viewer), 1.0F), 2 * reach_m});
    constexpr float kInGround_m = 0.6F;
    bool is_bridged = false;  // from the stone before to this one
    for (int i = 0; i < count; ++i) {
        const float turn = step * static_cast<float>(i);
        const glm::vec2 out{std::sin(turn), std::cos(turn)};
        const glm::vec2 across{out.y, -out.x};
        const glm::vec2 at = middle + reach_m * random.between(0.96F, 1.04F) * out;
        const bool bridges = random.unit() < 0.4 && i + 1 < count;
        const bool is_fallen = !bridges && !is_bridged && random.unit() < 0.15;
        const float height_m = (bridges || is_bridged ? 1.0F : random.between(0.6F, 1.05F)) * tall_m;
        if (past_roads_m(land, at) > 1.2F && scene::water_depth_m(land, at) <= 0) {
            const glm::vec3 foot{at.x, scene::ground_height_m(land, at) - kInGround_m, at.y};
            const float broad_m = 0.32F * tall_m * random.between(0.85F, 1.2F);
            const glm::vec3 size = is_fallen ? glm::vec3{height_m, kInGround_m + 0.8F, broad_m}
                                             : glm::vec3{broad_m, height_m + kInGround_m, 0.6F * broad_m};
            add_block(stones, strata, {foot, across, size, is_fallen ? 0.92F : 0.78F}, random);
            stones.footprints.push_back({at, 0.8F * broad_m});
        }
        if (bridges) {
            const float next = turn + 0.5F * step;
            const glm::vec2 way{std::sin(next), std::cos(next)};
            const glm::vec2 over = middle + reach_m * std::cos(0.5F * step) * way;
            const float top_m = land.site->middle_m.y + 0.96F * tall_m;
            add_block(stones, strata,
                      {{over.x, top_m, over.y},
                       {way.y, -way.x},
                       {2 * reach_m * std::sin(0.5F * step) + 0.3F * tall_m, 0.17F * tall_m, 0.24F * tall_m},
                       0.96F},
                      random);
        }
        is_bridged = bridges;
    }
}

}  // namespace quadrat::synthesis::land
