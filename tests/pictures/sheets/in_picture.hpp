// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "synthesis/compose/view_rays.hpp"

namespace quadrat::tests {

// Something made or rare, and how much of it a picture of 16 by 9 shows.
struct InPicture {
    std::string what;
    float size = 0;  // its height, of the picture's; of a road: the share of the picture that it covers
    float open = 0;  // of it, the share in the picture and hidden neither by land nor by plants
};

// What one looks through to see it: land and the crowns of plants, as upright cylinders.
class Look {
  public:
    Look(const scene::Scene& scene, const scene::Camera& camera) : scene_(scene), camera_(camera) {}

    // From the picture's middle, each -1 to 1; false where it is not in it.
    bool projects(const glm::vec3& at_m, glm::vec2& at) const {
        at = synthesis::in_picture(camera_, at_m).value_or(glm::vec2{2});
        return std::abs(at.x) < 1 && std::abs(at.y) < 1;
    }

    // own_m: how near to the place plants are its own and hide nothing.
    bool sees(const glm::vec3& at_m, float own_m) const {
        glm::vec2 at{0};
        if (!projects(at_m, at)) return false;
        const glm::vec3& eye = camera_.eye_m;
        const float distance_m = glm::distance(eye, at_m);
        if (synthesis::first_hit(*scene_.land, eye, (at_m - eye) / distance_m).distance_m < 0.94F * distance_m)
            return false;
        return std::ranges::none_of(scene_.plants,
                                    [&](const scene::Plant& plant) { return hides(plant, at_m, own_m); });
    }

    const scene::Camera& camera() const { return camera_; }

  private:
    bool hides(const scene::Plant& plant, const glm::vec3& at_m, float own_m) const {
        const scene::Species& species = scene_.flora->species[plant.species];
        const glm::vec2 from{camera_.eye_m.x, camera_.eye_m.z};
        const glm::vec2 to = glm::vec2{at_m.x, at_m.z} - from;
        const glm::vec2 root{plant.root_m.x, plant.root_m.z};
        const float along = glm::dot(root - from, to) / std::max(glm::dot(to, to), 1.0F);
        if (along <= 0 || along >= 1 || glm::distance(root, from + to) < own_m) return false;
        if (glm::distance(root, from + along * to) > 0.7F * species.crown_radius_m * plant.scale) return false;
        const float ray_m = camera_.eye_m.y + along * (at_m.y - camera_.eye_m.y) - plant.root_m.y;
        const float high_m = species.height_m * plant.scale;
        return ray_m < 0.95F * high_m && ray_m > (species.storey == scene::Storey::Tree ? 0.25F : 0.0F) * high_m;
    }

    const scene::Scene& scene_;
    const scene::Camera& camera_;
};

inline std::string name_of(const scene::Land& land, std::size_t landmark) {
    const scene::Landmark& mark = land.landmarks[landmark];
    if (mark.has_front) return "cave";
    if (landmark == 0 && !land.settlement.is_empty()) return "houses";
    const glm::vec2 at{mark.at_m.x, mark.at_m.z};
    if (land.site && glm::distance(at, glm::vec2{land.site->middle_m.x, land.site->middle_m.z}) < 1) return "stones";
    return "rock";
}

inline InPicture landmark_in(const scene::Scene& scene, const Look& look, std::size_t landmark) {
    const scene::Landmark& mark = scene.land->landmarks[landmark];
    const scene::Camera& camera = look.camera();
    const glm::vec3 to = mark.at_m - camera.eye_m;
    const float distance_m = glm::length(to);
    const glm::vec3 right = glm::normalize(glm::cross(to, glm::vec3{0, 1, 0}));
    InPicture seen{name_of(*scene.land, landmark)};
    seen.size = mark.size_m / distance_m / (2 * std::tan(glm::radians(0.5F * camera.vertical_fov_deg)));
    const glm::vec2 back = glm::normalize(glm::vec2{-to.x, -to.z});
    if (mark.has_front && glm::dot(back, mark.faces) < 0.5F) return seen;
    for (const float aside : {-0.35F, 0.0F, 0.35F})
        for (const float up : {-0.1F, 0.1F, 0.3F})
            seen.open +=
                look.sees(mark.at_m + mark.size_m * (aside * right + glm::vec3{0, up, 0}), 0.5F * mark.size_m) / 9.0F;
    return seen;
}

// Of all roads that are no lanes.
inline InPicture roads_in(const scene::Scene& scene, const Look& look) {
    InPicture seen{"road"};
    float whole = 0;
    for (const scene::Road& road : scene.land->roads)
        for (std::size_t i = 0; i + 1 < road.line_m.size() && !road.is_lane; ++i) {
            const glm::vec3 a = road.line_m[i];
            const glm::vec3 along = road.line_m[i + 1] - a;
            const glm::vec3 aside =
                0.5F * road.width_m * glm::normalize(glm::vec3{-along.z, 0, along.x} + glm::vec3{1e-5F, 0, 0});
            glm::vec2 left{0}, right{0}, next{0};
            if (!look.projects(a - aside, left) || !look.projects(a + aside, right) || !look.projects(a + along, next))
                continue;
            const glm::vec2 across = right - left;
            const glm::vec2 on = next - 0.5F * (left + right);
            const float share = std::abs(across.x * on.y - across.y * on.x) / 4;
            whole += share;
            if (look.sees(a + glm::vec3{0, 0.3F, 0}, 0)) seen.size += share;
        }
    seen.open = whole > 0 ? seen.size / whole : 0;
    return seen;
}

inline std::vector<InPicture> all_in_picture(const scene::Scene& scene, float seconds) {
    const scene::Camera camera = scene::camera_at(scene.track, seconds);
    const Look look(scene, camera);
    std::vector<InPicture> all;
    for (std::size_t i = 0; i < scene.land->landmarks.size(); ++i) all.push_back(landmark_in(scene, look, i));
    if (!scene.land->roads.empty()) all.push_back(roads_in(scene, look));
    return all;
}

}  // namespace quadrat::tests
