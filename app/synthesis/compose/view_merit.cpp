// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/view_merit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
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

// Where the picture holds a point, its distance; less than 0 where it does not.
float distance_in_picture_m(const scene::Camera& camera, const glm::vec3& at_m) {
    constexpr float kMargin = 0.92F;
    const std::optional<glm::vec2> at = in_picture(camera, at_m);
    const bool is_in = at && std::max(std::abs(at->x), std::abs(at->y)) < kMargin;
    return is_in ? glm::distance(at_m, camera.eye_m) : -1.0F;
}

bool is_behind_land(const scene::Land& land, const glm::vec3& eye_m, const glm::vec3& at_m, float distance_m) {
    return first_hit(land, eye_m, (at_m - eye_m) / distance_m).distance_m < 0.94F * distance_m;
}

void look_for_landmarks(const scene::Land& land, const scene::Camera& camera, Outlook& seen) {
    const std::vector<scene::Landmark> all = landmarks_of(land);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const scene::Landmark& mark = all[i];
        const float distance_m = distance_in_picture_m(camera, mark.at_m);
        if (distance_m < 0 || distance_m > 320) continue;
        const glm::vec2 to_eye{camera.eye_m.x - mark.at_m.x, camera.eye_m.z - mark.at_m.z};
        if (mark.has_front && glm::dot(to_eye, mark.faces) < 0.5F * glm::length(to_eye)) continue;
        if (is_behind_land(land, camera.eye_m, mark.at_m, distance_m)) continue;
        seen.made += mark.size_m / distance_m;
        if (i >= land.landmarks.size()) continue;
        float& largest = mark.has_front ? seen.cave : seen.marked;
        largest = std::max(largest, mark.size_m / distance_m / kLandmark);
    }
}

// A road far away is a thread, however much of it there is: what counts is how much of the picture it covers.
float road_in_sight(const scene::Land& land, const scene::Camera& camera) {
    constexpr float kFarthest_m = 160;
    const float half = std::tan(glm::radians(0.5F * camera.vertical_fov_deg));
    const float picture = 4 * half * half * 16 / 9;
    float sum = 0;
    for (const scene::Road& road : land.roads)
        for (std::size_t i = 0; i + 1 < road.line_m.size() && !road.is_lane; ++i) {
            const glm::vec3& at_m = road.line_m[i];
            const glm::vec3 to_eye = camera.eye_m - at_m;
            if (glm::dot(to_eye, to_eye) > kFarthest_m * kFarthest_m) continue;
            const float distance_m = distance_in_picture_m(camera, at_m);
            if (distance_m < 0) continue;
            const float faces = glm::dot(to_eye, scene::ground_normal(land, {at_m.x, at_m.z})) / distance_m;
            if (faces <= 0 || is_behind_land(land, camera.eye_m, at_m + glm::vec3{0, 0.3F, 0}, distance_m)) continue;
            const float area_m2 = road.width_m * glm::distance(at_m, road.line_m[i + 1]);
            sum += area_m2 * faces / (distance_m * distance_m) / picture;
        }
    return sum;
}

// Some houses tell of all.
float housed_share(const scene::Land& land, const scene::Camera& camera) {
    constexpr std::size_t kLookedAt = 16;
    constexpr float kLarge_rad = 0.03F;  // a house that counts in full: some 20 of 720 lines
    const std::vector<scene::House>& houses = land.settlement.houses;
    const std::size_t step = houses.size() / kLookedAt + 1;
    float sum = 0;
    int looked_at = 0;
    for (std::size_t i = 0; i < houses.size(); i += step) {
        ++looked_at;
        const float height_m = land.settlement.buildings[houses[i].building].height_m;
        const glm::vec3 top_m = houses[i].foot_m + glm::vec3{0, 0.7F * height_m, 0};
        const float distance_m = distance_in_picture_m(camera, top_m);
        if (distance_m < 0 || is_behind_land(land, camera.eye_m, top_m, distance_m)) continue;
        sum += std::min(height_m / distance_m / kLarge_rad, 1.0F);
    }
    return looked_at > 0 ? sum / static_cast<float>(looked_at) : 0.0F;
}

// How high arches, outcrops and boulders about an eye rise in its picture, by bearing.
class NearStone {
  public:
    NearStone(const scene::Land& land, const glm::vec3& eye_m) {
        constexpr float kBuried_m = 0.3F;
        for (const glm::vec3& p : land.stone.mesh.positions_m) {
            const glm::vec2 off_m{p.x - eye_m.x, p.z - eye_m.z};
            const float away_m = glm::length(off_m);
            if (away_m > kNear_m || away_m < kTooNear_m) continue;
            if (p.y < scene::ground_height_m(land, {p.x, p.z}) + kBuried_m) continue;
            Side& side = sides_[side_of(off_m)];
            side.rise = std::max(side.rise, (p.y - eye_m.y) / away_m);
            side.nearest_m = std::min(side.nearest_m, away_m);
        }
    }

    bool stands_before(const glm::vec3& ray, float land_m) const {
        const float level = std::hypot(ray.x, ray.z);
        const Side& side = sides_[side_of({ray.x, ray.z})];
        return ray.y < side.rise * level && side.nearest_m < land_m * level;
    }

  private:
    static constexpr float kNear_m = 55;
    static constexpr float kTooNear_m = 1;
    static constexpr std::size_t kSides = 72;  // five degrees each: as far apart as rays are
    struct Side {
        float rise = -1.0e6F;  // of the highest point, over its distance
        float nearest_m = 1.0e6F;
    };
    static std::size_t side_of(const glm::vec2& to) {
        const float turns = std::atan2(to.x, -to.y) / glm::two_pi<float>() + 1;
        return static_cast<std::size_t>(turns * kSides) % kSides;
    }
    std::array<Side, kSides> sides_;
};

// Of a picture, what rock covers from its left side on and from its right one: what stands whole within it is a
// subject.
float cut_off(const std::array<float, kRayColumns>& stone) {
    const auto is_bare = [](float share) { return share <= 0; };
    const auto left = std::ranges::find_if(stone, is_bare);
    const auto right = std::find_if(stone.rbegin(), std::make_reverse_iterator(left), is_bare);
    return std::accumulate(stone.begin(), left, 0.0F) + std::accumulate(stone.rbegin(), right, 0.0F);
}

// The houses about an eye as boxes, to ask of many rays.
class NearHouses {
  public:
    NearHouses(const scene::Settlement& settlement, const glm::vec3& eye) {
        for (const scene::House& house : settlement.houses) {
            if (glm::length(house.foot_m - eye) > 1.5F * kNear_m) continue;
            const scene::Building& building = settlement.buildings[house.building];
            const float cosine = std::cos(house.yaw_rad);
            const float sine = std::sin(house.yaw_rad);
            const glm::vec3 off_m = eye - house.foot_m;
            // A roof is narrower than its walls.
            boxes_.push_back({{cosine * off_m.x - sine * off_m.z, off_m.y, sine * off_m.x + cosine * off_m.z},
                              {building.half_m.x, kBelowRidge * building.height_m, building.half_m.y},
                              cosine,
                              sine});
        }
    }

    bool stand_before(const glm::vec3& ray, float land_m) const {
        return std::ranges::any_of(boxes_, [&](const Box& box) {
            const glm::vec3 along{box.cosine * ray.x - box.sine * ray.z, ray.y, box.sine * ray.x + box.cosine * ray.z};
            const glm::vec3 low = (glm::vec3{-box.size_m.x, 0, -box.size_m.z} - box.eye_m) / along;
            const glm::vec3 high = (box.size_m - box.eye_m) / along;
            const glm::vec3 in = glm::min(low, high);
            const glm::vec3 out = glm::max(low, high);
            const float enters_m = std::max({in.x, in.y, in.z, 0.0F});
            return enters_m < std::min({out.x, out.y, out.z}) && enters_m < std::min(kNear_m, land_m);
        });
    }

  private:
    static constexpr float kNear_m = 32;
    static constexpr float kBelowRidge = 0.85F;
    struct Box {
        glm::vec3 eye_m;   // where it stands in the house's own directions, from its foot
        glm::vec3 size_m;  // half its width, its height, half its depth
        float cosine, sine;
    };
    std::vector<Box> boxes_;
};

}  // namespace

Outlook outlook(const scene::Land& land, const scene::Camera& camera) {
    Outlook seen;
    const std::vector<glm::vec3> rays = view_rays(camera);
    const float share = 1.0F / static_cast<float>(rays.size());
    const NearHouses houses(land.settlement, camera.eye_m);
    const NearStone stone(land, camera.eye_m);
    std::array<float, kRayColumns> stony{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3& ray = rays[i];
        const Hit hit = first_hit(land, camera.eye_m, ray);
        if (houses.stand_before(ray, hit.distance_m)) {
            seen.roofed += share;
            continue;
        }
        if (stone.stands_before(ray, hit.distance_m)) {
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
    look_for_landmarks(land, camera, seen);
    seen.road = road_in_sight(land, camera);
    seen.stony = cut_off(stony);
    seen.housed = housed_share(land, camera);
    return seen;
}

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
