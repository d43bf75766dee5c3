// SPDX-License-Identifier: Apache-2.0
#include "render/held_ground.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "render/view.hpp"

namespace quadrat::render {
namespace {

// The longer of its sides along the axes, in cells: with one of its own in every power of two, however it lies.
std::uint32_t side_of(const std::uint32_t* triangle, std::uint32_t columns) {
    const auto [west, east] = std::minmax({triangle[0] % columns, triangle[1] % columns, triangle[2] % columns});
    const auto [north, south] = std::minmax({triangle[0] / columns, triangle[1] / columns, triangle[2] / columns});
    return std::max(east - west, south - north);
}

// Where the land is drawn by ROAM: adapts it to the eye. How much lower than the land what is drawn may lie then, for
// each metre from the eye; blocks lie within their own bounds.
float adapted(const passes::GridOnGpu& land, const choose::Frustum& frustum, const choose::Blocks::Wish& wish) {
    if (!land.roam) return 0;
    land.roam->update({wish.eye_m, wish.pixels_per_radian, wish.error_px, wish.triangle_budget, {frustum.planes()}});
    return land.roam->error_px() / wish.pixels_per_radian;
}

// Of the box about a triangle, within which its grain could be.
float nearest_m(const mesh::Roam& roam, const std::uint32_t* triangle, glm::vec3 eye_m) {
    const glm::vec3 a = roam.place_m(triangle[0]);
    const glm::vec3 b = roam.place_m(triangle[1]);
    const glm::vec3 c = roam.place_m(triangle[2]);
    return glm::distance(eye_m, glm::clamp(eye_m, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))));
}

}  // namespace

void HeldGround::update(const View& view, const glm::mat4& clip_from_world, const Wish& wish) {
    sent_bytes_ = 0;
    if (scene_.lock() == view.scene && wish_ == wish && hold_.serves(view.camera)) return;
    if (scene_.lock() != view.scene) sight_.drop();
    scene_ = view.scene;
    wish_ = wish;
    hold_.choose(view.camera);
    chosen_.clear();
    const choose::Frustum frustum = choose::Hold::wider(strip_of(clip_from_world, wish.strip));
    const CountryOnGpu& country = *view.scene->country;
    const choose::Allowance& allowance = wish.allowance;
    grain_m_ = passes::kGrainSeen_m * wish.pixels_per_radian * allowance.grain;
    const auto within = [&](float error_px, float triangles) {
        return choose::Blocks::Wish{
            view.camera.eye_m, wish.pixels_per_radian, error_px, static_cast<std::size_t>(triangles), grain_m_, {},
            wish.reach};
    };
    choose::Blocks::Wish land = within(allowance.land_error_px, allowance.land_triangles);
    choose::Blocks::Wish surround = within(allowance.surround_error_px, allowance.surround_triangles);
    look_around(*view.scene, view.camera, choose::Hold::wider(clip_from_world),
                adapted(country.land.land, frustum, land));
    land.hidden = hidden_land_;
    surround.hidden = hidden_surround_;
    land_ = choose(country.land.land, frustum, land);
    surround_ = choose(country.land.surround, frustum, surround);
    const std::size_t first = chosen_.size();
    country.stone.pieces.select(
        frustum, {view.camera.eye_m, wish.pixels_per_radian, allowance.stone_error_px, &horizon_, wish.reach}, chosen_);
    stone_ = {first, chosen_.size() - first, 0, 0};
    const std::size_t first_house = chosen_.size();
    country.houses.levels.select(
        frustum,
        {view.camera.eye_m, wish.pixels_per_radian, allowance.house_fineness, wish.growth, &horizon_, wish.reach},
        chosen_);
    houses_ = {first_house, chosen_.size() - first_house, 0, 0};
    indices_.fill<std::uint32_t>(chosen_);
    sent_bytes_ = chosen_.size() * sizeof(std::uint32_t);
}

// Anew only where the last look no longer serves: it costs as much as the choice does.
void HeldGround::look_around(const GpuScene& scene, const scene::Camera& camera, const choose::Frustum& frustum,
                             float sunk) {
    constexpr float kRoom = 1.3F;  // for a step of what a budget makes of the wish
    if (sight_.serves(camera) && sunk <= sunk_) return;
    sight_.choose(camera);
    sunk_ = kRoom * sunk;
    horizon_.begin(camera.eye_m, choose::Horizon::kMoved_m + choose::Hold::kMoved_m, sunk_);
    const auto hidden_of = [&](const passes::GridOnGpu& grid) {
        return grid.blocks ? grid.blocks->hidden(frustum, camera.eye_m, horizon_) : std::vector<std::uint8_t>{};
    };
    hidden_land_ = hidden_of(scene.country->land.land);
    hidden_surround_ = hidden_of(scene.country->land.surround);
}

void HeldGround::drop() {
    hold_.drop();
    sight_.drop();
    horizon_.begin({0, 0, 0}, 0);
    chosen_.clear();
    land_ = surround_ = stone_ = houses_ = {};
    sent_bytes_ = 0;
}

void HeldGround::sort_by_level(const GpuScene& scene) {
    const auto columns = static_cast<std::uint32_t>(scene.country->land.land.columns);
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_step;
    for (std::size_t i = land_.first; i < land_.first + land_.count; i += 3) {
        auto& level = by_step[std::bit_ceil(side_of(&chosen_[i], columns))];
        level.insert(level.end(), &chosen_[i], &chosen_[i] + 3);
    }
    std::vector<std::uint32_t> sorted;
    land_by_level_.clear();
    for (const auto& [step, indices] : by_step) {
        choose::IndexRange range = land_;
        range.first = sorted.size();
        range.count = indices.size();
        range.near_count = 0;
        range.level = static_cast<std::size_t>(std::countr_zero(step));
        land_by_level_.push_back(range);
        sorted.insert(sorted.end(), indices.begin(), indices.end());
    }
    level_indices_.fill<std::uint32_t>(sorted);
}

choose::IndexRange HeldGround::choose(const passes::GridOnGpu& grid, const choose::Frustum& frustum,
                                      const choose::Blocks::Wish& wish) {
    if (grid.roam) return choose_by_roam(*grid.roam, frustum, wish);
    if (!grid.blocks) return {};
    const std::size_t first = chosen_.size();
    const choose::Blocks::Selected selected = grid.blocks->select(frustum, wish, chosen_);
    return {first, chosen_.size() - first, selected.near_indices, choose::ease_of(wish, selected.error_px)};
}

// Nothing eases: each of its vertices lies where the land does. An ease of 0 puts the eye so near to all of them that
// none has begun to leave.
choose::IndexRange HeldGround::choose_by_roam(const mesh::Roam& roam, const choose::Frustum& frustum,
                                              const choose::Blocks::Wish& wish) {
    constexpr float kNoEase = 0;
    const std::size_t first = chosen_.size();
    roam.append_indices(frustum.planes(), chosen_);
    farther_.clear();
    std::size_t nearer = first;
    for (std::size_t i = first; i < chosen_.size(); i += 3) {
        const std::uint32_t* triangle = &chosen_[i];
        if (nearest_m(roam, triangle, wish.eye_m) >= wish.near_m) {
            farther_.insert(farther_.end(), triangle, triangle + 3);
        } else {
            std::copy_n(triangle, 3, &chosen_[nearer]);
            nearer += 3;
        }
    }
    std::ranges::copy(farther_, chosen_.begin() + static_cast<std::ptrdiff_t>(nearer));
    return {first, chosen_.size() - first, nearer - first, kNoEase};
}

}  // namespace quadrat::render
