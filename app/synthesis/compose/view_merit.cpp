// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/view_merit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <numeric>

#include "synthesis/compose/view_rays.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kLandmark = 2.5F;  // one thing is worth more than as many metres of boulders

// Something a country does not have everywhere, and how large it is: landmarks, then tall stones.
std::vector<scene::Landmark> landmarks_of(const scene::Land& land) {
    std::vector<scene::Landmark> all = land.landmarks;
    for (scene::Landmark& mark : all) mark.size_m *= kLandmark;
    // What stands higher over the ground than boulders do. A facet has three corners of its own: some of them tell.
    constexpr std::size_t kStoneStep = 31;
    constexpr float kTall_m = 2.6F;
    for (std::size_t i = 0; i < land.stone.mesh.positions_m.size(); i += kStoneStep) {
        const glm::vec3& p = land.stone.mesh.positions_m[i];
        const float over_m = p.y - scene::ground_height_m(land, {p.x, p.z});
        if (over_m > kTall_m) all.push_back({p, {0, 1}, 0.5F * over_m, false});
    }
    return all;
}

bool holds(const Picture& picture, const glm::vec3& at_m) {
    constexpr float kMargin = 0.92F;
    const std::optional<glm::vec2> at = picture.at(at_m);
    return at && std::max(std::abs(at->x), std::abs(at->y)) < kMargin;
}

// Of a picture, what rock covers from its left side on and from its right one: what stands whole within it is a
// subject.
float cut_off(const std::array<float, kRayColumns>& stone) {
    const auto is_bare = [](float share) { return share <= 0; };
    const auto left = std::ranges::find_if(stone, is_bare);
    const auto right = std::find_if(stone.rbegin(), std::make_reverse_iterator(left), is_bare);
    return std::accumulate(stone.begin(), left, 0.0F) + std::accumulate(stone.rbegin(), right, 0.0F);
}

}  // namespace

Lookout::Lookout(const scene::Land& land)
    : land_(&land), ceiling_m_(ceiling_over_m(land)), marks_(landmarks_of(land)), rock_(land) {
    for (const scene::Road& road : land.roads)
        for (std::size_t i = 0; i + 1 < road.line_m.size() && !road.is_lane; ++i) {
            const glm::vec3& at_m = road.line_m[i];
            roads_.push_back({at_m, scene::ground_normal(land, {at_m.x, at_m.z}),
                              road.width_m * glm::distance(at_m, road.line_m[i + 1])});
        }
}

bool Lookout::is_behind_land(const glm::vec3& eye_m, const glm::vec3& at_m, float distance_m) const {
    const float before_m = 0.94F * distance_m;
    return first_hit(*land_, eye_m, (at_m - eye_m) / distance_m, {ceiling_m_, before_m}).distance_m < before_m;
}

void Lookout::look_for_landmarks(const glm::vec3& eye_m, const Picture& picture, Outlook& seen) const {
    constexpr float kFarthestMark_m = 320;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const scene::Landmark& mark = marks_[i];
        const float distance_m = glm::distance(mark.at_m, eye_m);
        if (distance_m > kFarthestMark_m || !holds(picture, mark.at_m)) continue;
        const glm::vec2 to_eye{eye_m.x - mark.at_m.x, eye_m.z - mark.at_m.z};
        if (mark.has_front && glm::dot(to_eye, mark.faces) < 0.5F * glm::length(to_eye)) continue;
        if (is_behind_land(eye_m, mark.at_m, distance_m)) continue;
        seen.made += mark.size_m / distance_m;
        if (i >= land_->landmarks.size()) continue;
        float& largest = mark.has_front ? seen.cave : seen.marked;
        largest = std::max(largest, mark.size_m / distance_m / kLandmark);
    }
}

// A road far away is a thread, however much of it there is: what counts is how much of the picture it covers.
float Lookout::road_in_sight(const scene::Camera& camera, const Picture& picture) const {
    constexpr float kFarthestRoad_m = 160;
    const float half = std::tan(glm::radians(0.5F * camera.vertical_fov_deg));
    const float whole = 4 * half * half * 16 / 9;
    float sum = 0;
    for (const Stretch& road : roads_) {
        const glm::vec3 to_eye = camera.eye_m - road.at_m;
        if (glm::dot(to_eye, to_eye) > kFarthestRoad_m * kFarthestRoad_m || !holds(picture, road.at_m)) continue;
        const float distance_m = glm::distance(road.at_m, camera.eye_m);
        const float faces = glm::dot(to_eye, road.ground_normal) / distance_m;
        if (faces <= 0 || is_behind_land(camera.eye_m, road.at_m + glm::vec3{0, 0.3F, 0}, distance_m)) continue;
        sum += road.area_m2 * faces / (distance_m * distance_m) / whole;
    }
    return sum;
}

// Some houses tell of all.
float Lookout::housed_share(const glm::vec3& eye_m, const Picture& picture) const {
    constexpr std::size_t kLookedAt = 16;
    constexpr float kLarge_rad = 0.03F;  // a house that counts in full: some 20 of 720 lines
    const std::vector<scene::House>& houses = land_->settlement.houses;
    const std::size_t step = houses.size() / kLookedAt + 1;
    float sum = 0;
    int looked_at = 0;
    for (std::size_t i = 0; i < houses.size(); i += step) {
        ++looked_at;
        const float height_m = land_->settlement.buildings[houses[i].building].height_m;
        const glm::vec3 top_m = houses[i].foot_m + glm::vec3{0, 0.7F * height_m, 0};
        if (!holds(picture, top_m)) continue;
        const float distance_m = glm::distance(top_m, eye_m);
        if (is_behind_land(eye_m, top_m, distance_m)) continue;
        sum += std::min(height_m / distance_m / kLarge_rad, 1.0F);
    }
    return looked_at > 0 ? sum / static_cast<float>(looked_at) : 0.0F;
}

Outlook Lookout::outlook(const scene::Camera& camera) const {
    Outlook seen;
    const std::vector<glm::vec3> rays = view_rays(camera);
    const float share = 1.0F / static_cast<float>(rays.size());
    const NearHouses houses(land_->settlement, camera.eye_m);
    const NearRock rock(rock_, camera.eye_m);
    std::array<float, kRayColumns> stony{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3& ray = rays[i];
        const Hit hit = first_hit(*land_, camera.eye_m, ray, {ceiling_m_});
        if (houses.stand_before(ray, hit.distance_m)) {
            seen.roofed += share;
            continue;
        }
        if (rock.stands_before(ray, hit.distance_m)) {
            stony[i % kRayColumns] += share;
            continue;
        }
        if (hit.distance_m >= kFarthest_m)
            seen.sky += share;
        else if (hit.is_water)
            seen.water += share;
        else if (hit.distance_m < 45)
            seen.near += share;
        else if (hit.distance_m > 500)
            seen.far += share;
        // Ground at one's feet is no wall.
        if (!hit.is_water && hit.distance_m < 12 && ray.y > -0.12F) seen.walled += share;
    }
    const Picture picture(camera);
    look_for_landmarks(camera.eye_m, picture, seen);
    seen.road = road_in_sight(camera, picture);
    seen.stony = cut_off(stony);
    seen.housed = housed_share(camera.eye_m, picture);
    return seen;
}

Outlook outlook(const scene::Land& land, const scene::Camera& camera) { return Lookout(land).outlook(camera); }

float view_merit(const Outlook& seen) {
    // What a land does not have everywhere is why one stops. A mouth is smaller than an arch, and shows from its front
    // alone: were it worth no more, an arch beside it would always have the picture.
    constexpr float kArch = 0.8F;
    constexpr float kCave = 1.0F;
    constexpr float kRoad = 1.2F;
    const auto up_to = [](float share, float enough) { return std::min(share / enough, 1.0F); };
    const float off_sky = (seen.sky - 0.42F) / 0.25F;
    const float too_much = std::max(seen.near - 0.42F, 0.0F) + std::max(seen.water - 0.30F, 0.0F);
    return up_to(seen.near, 0.16F) + 0.9F * up_to(seen.far, 0.10F) + 0.8F * up_to(seen.water, 0.10F) +
           1.2F * up_to(seen.made, 0.7F) + kArch * up_to(seen.marked, 0.2F) + kCave * up_to(seen.cave, 0.15F) +
           kRoad * up_to(seen.road, 0.03F) + 1.4F * up_to(seen.housed, 0.6F) - 0.8F * off_sky * off_sky - 3 * too_much -
           4 * std::max(seen.walled - 0.10F, 0.0F) - 4 * std::max(seen.roofed - 0.20F, 0.0F) -
           5 * std::max(seen.stony - 0.10F, 0.0F);
}

}  // namespace quadrat::synthesis
