// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/near_shade.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr float kWhole_m = 20;    // from the flight's way the shade is whole
constexpr float kNone_m = 66;     // and from here on there is none
constexpr float kOnTrees = 0.3F;  // of it: their crowns rise out of it into the light, and stand out

class NearShade {
  public:
    NearShade(const scene::Track& track, float left) : track_(track), left_(left) {
        for (const scene::Camera& camera : track.cameras) {
            low_ = glm::min(low_, glm::vec2{camera.eye_m.x, camera.eye_m.z} - kNone_m);
            high_ = glm::max(high_, glm::vec2{camera.eye_m.x, camera.eye_m.z} + kNone_m);
        }
    }
    glm::vec2 low() const { return low_; }
    glm::vec2 high() const { return high_; }

    // What is left of the light.
    float at(glm::vec2 at_m) const {
        float nearest_m = 1.0e6F;
        for (const scene::Camera& camera : track_.cameras)
            nearest_m = std::min(nearest_m, glm::distance(at_m, glm::vec2{camera.eye_m.x, camera.eye_m.z}));
        // No cloud's edge is a curve of even distance.
        const float wander_m = 5.0F * std::sin(0.11F * at_m.x + 1.3F * std::sin(0.05F * at_m.y)) +
                               4.0F * std::sin(0.13F * at_m.y + 2.1F + 0.9F * std::sin(0.07F * at_m.x));
        return left_ + (1 - left_) * glm::smoothstep(kWhole_m, kNone_m - 9.0F, nearest_m + wander_m);
    }

  private:
    const scene::Track& track_;
    float left_;
    glm::vec2 low_{1.0e6F};
    glm::vec2 high_{-1.0e6F};
};

}  // namespace

void shade_what_is_near(scene::BakedLight& light, std::span<scene::Plant> plants, const scene::Flora& flora,
                        const scene::Track& track, float side_m, float left) {
    if (light.ground.bytes.empty() || track.cameras.empty()) return;
    const NearShade shade(track, left);
    mesh::Image& ground = light.ground;
    const float px_m = side_m / static_cast<float>(ground.width);
    const auto px = [&](float m) {
        return std::clamp(static_cast<int>((m + 0.5F * side_m) / px_m), 0, ground.width - 1);
    };
    oneapi::tbb::parallel_for(px(shade.low().y), px(shade.high().y) + 1, [&](int y) {
        for (int x = px(shade.low().x); x <= px(shade.high().x); ++x) {
            const glm::vec2 at_m = (glm::vec2{x, y} + 0.5F) * px_m - 0.5F * side_m;
            const float of_light = shade.at(at_m);
            std::uint8_t* pixel = ground.pixel(x, y);
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(static_cast<float>(pixel[c]) * of_light + 0.5F);
        }
    });
    oneapi::tbb::parallel_for(std::size_t{0}, plants.size(), [&](std::size_t i) {
        const bool is_tree = flora.species[plants[i].species].storey == scene::Storey::Tree;
        const float of_light = shade.at({plants[i].root_m.x, plants[i].root_m.z});
        plants[i].sun *= is_tree ? glm::mix(1.0F, of_light, kOnTrees) : of_light;
    });
}

}  // namespace quadrat::synthesis
