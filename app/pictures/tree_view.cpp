// SPDX-License-Identifier: Apache-2.0
#include "pictures/tree_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::pictures {
namespace {

float width_of(const scene::Scene& scene, const scene::Plant& plant) {
    return 2 * scene.flora->species[plant.species].crown_radius_m * plant.scale;
}

// How much free room there is from its crown to the next one, at most as much as its own width is worth.
float room_m(const scene::Scene& scene, const scene::Plant& tree) {
    float room = 2 * width_of(scene, tree);
    for (const scene::Plant& other : scene.plants) {
        if (&other == &tree || scene.flora->species[other.species].storey != scene::Storey::Tree) continue;
        const float apart = std::hypot(other.root_m.x - tree.root_m.x, other.root_m.z - tree.root_m.z);
        room = std::min(room, apart - 0.5F * (width_of(scene, other) + width_of(scene, tree)));
    }
    return room;
}

// In any of its forms.
bool is_of_the_first(const scene::Scene& scene, const scene::Plant& plant) {
    const scene::Species& first = scene.flora->species[0];
    const auto species = static_cast<int>(plant.species);
    return species == 0 || species == first.in_stand || species == first.at_edge;
}

}  // namespace

std::optional<scene::Camera> camera_on_a_tree(const scene::Scene& scene) {
    const scene::Plant* chosen = nullptr;
    float best = 0;
    const float reach_m = 0.35F * scene.land->side_m();
    for (const scene::Plant& plant : scene.plants) {
        if (!is_of_the_first(scene, plant) || std::max(std::abs(plant.root_m.x), std::abs(plant.root_m.z)) > reach_m)
            continue;
        // A sapling is no specimen.
        const float merit = plant.scale * (1 + 0.1F * room_m(scene, plant));
        if (chosen != nullptr && merit <= best) continue;
        chosen = &plant;
        best = merit;
    }
    if (chosen == nullptr) return std::nullopt;
    const float height_m = scene.flora->species[chosen->species].height_m * chosen->scale;
    const glm::vec3 sun = scene.sky->sun_direction;
    // A little aside of the sun: lit, and round.
    const float azimuth = std::atan2(sun.x, -sun.z) + glm::radians(35.0F);
    const glm::vec2 from = glm::vec2{std::sin(azimuth), -std::cos(azimuth)};
    const float away_m = 1.1F * std::max(height_m, width_of(scene, *chosen)) + 1;
    scene::Camera camera;
    camera.vertical_fov_deg = 52;
    camera.target_m = chosen->root_m + glm::vec3{0, 0.5F * height_m, 0};
    camera.eye_m = camera.target_m + glm::vec3{from.x * away_m, 0, from.y * away_m};
    camera.eye_m.y = std::max(chosen->root_m.y + 0.3F * height_m,
                              scene::ground_height_m(*scene.land, {camera.eye_m.x, camera.eye_m.z}) + 1.5F);
    return camera;
}

}  // namespace quadrat::pictures
