// SPDX-License-Identifier: Apache-2.0
#include "render/choose/house_levels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

namespace quadrat::render::choose {
namespace {

constexpr float kNear_px_per_m = 5.5F;  // from there on every pane is seen,
constexpr float kMiddle_px_per_m = 2.0F;
constexpr float kLeast_px = 0.7F;

// Which houses have their finest level: as many as a viewer in the south could come near.
std::vector<bool> with_finest(const scene::Settlement& settlement) {
    constexpr glm::vec2 kViewer_m{0, 270};
    constexpr std::size_t kMost = 90;
    std::vector<std::size_t> order(settlement.houses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto away_m = [&](std::size_t i) {
        const glm::vec3& foot = settlement.houses[i].foot_m;
        return glm::distance(glm::vec2{foot.x, foot.z}, kViewer_m);
    };
    std::ranges::stable_sort(order, {}, away_m);
    std::vector<bool> has(order.size(), false);
    for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i) has[order[i]] = true;
    return has;
}

}  // namespace

std::vector<SentLevel> sent_levels(const scene::Settlement& settlement) {
    const std::vector<bool> has_finest = with_finest(settlement);
    std::vector<SentLevel> sent;
    for (std::size_t i = 0; i < settlement.houses.size(); ++i) {
        const std::size_t levels = settlement.buildings[settlement.houses[i].building].levels.size();
        for (std::size_t level = has_finest[i] ? 0 : 1; level < levels; ++level) sent.push_back({i, level});
    }
    return sent;
}

HouseLevels::HouseLevels(const scene::Settlement& settlement) {
    std::vector<std::size_t> first_list;
    for (const scene::Building& building : settlement.buildings) {
        first_list.push_back(indices_.size());
        for (const scene::Masses& level : building.levels) indices_.push_back(level.mesh.indices);
    }
    std::uint32_t corner = 0;
    for (const scene::House& house : settlement.houses) {
        const scene::Building& building = settlement.buildings[house.building];
        standing_.push_back({house.foot_m + glm::vec3{0, 0.5F * building.height_m, 0},
                             glm::length(glm::vec3{building.half_m, 0.5F * building.height_m}) + 1,
                             {}});
    }
    for (const SentLevel& sent : sent_levels(settlement)) {
        Standing& standing = standing_[sent.house];
        const std::uint32_t building = settlement.houses[sent.house].building;
        standing.finest = std::min(standing.finest, sent.level);
        standing.levels.push_back({corner, first_list[building] + sent.level});
        corner += static_cast<std::uint32_t>(settlement.buildings[building].levels[sent.level].mesh.positions_m.size());
    }
    for (const scene::Masses& piece : settlement.bounds) {
        const std::vector<glm::vec3>& places = piece.mesh.positions_m;
        glm::vec3 low = places.front();
        glm::vec3 high = low;
        for (const glm::vec3& p : places) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        standing_.push_back({0.5F * (low + high), 0.5F * glm::distance(low, high), {{corner, indices_.size()}}, 0});
        indices_.push_back(piece.mesh.indices);
        corner += static_cast<std::uint32_t>(places.size());
    }
}

void HouseLevels::select(const Frustum& frustum, const Wish& wish, std::vector<std::uint32_t>& indices) const {
    const auto built = static_cast<std::size_t>(std::ceil(wish.standing * static_cast<float>(standing_.size())));
    for (const Standing& house : std::span(standing_).first(std::min(built, standing_.size()))) {
        const float distance_m = std::max(glm::distance(house.middle_m, wish.eye_m) - house.radius_m, 0.5F);
        const float px_per_m = wish.pixels_per_radian / distance_m;
        if (house.radius_m * px_per_m < kLeast_px) continue;
        if (!wish.reach.may_hold_sphere(house.middle_m, house.radius_m)) continue;
        if (!frustum.may_see_sphere(house.middle_m, house.radius_m)) continue;
        if (wish.horizon && wish.horizon->hides_standing({house.middle_m.x, house.middle_m.z}, house.radius_m,
                                                         house.middle_m.y + house.radius_m))
            continue;
        const float fine = px_per_m * wish.fineness;
        const std::size_t wished = fine > kNear_px_per_m ? 0 : fine > kMiddle_px_per_m ? 1 : 2;
        const std::size_t wanted = std::max(wished, house.finest) - house.finest;
        const Level& level = house.levels[std::min(wanted, house.levels.size() - 1)];
        for (const std::uint32_t index : indices_[level.list]) indices.push_back(level.first + index);
    }
}

}  // namespace quadrat::render::choose
