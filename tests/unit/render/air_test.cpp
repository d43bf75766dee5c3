// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/seed.hpp"
#include "render/choose/air.hpp"
#include "render/choose/cloud_light.hpp"
#include "render/gpu_scene.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/view.hpp"

namespace quadrat::render::choose {
namespace {

ViewBlock misty(float level_m, float depth_m, glm::vec3 eye) {
    ViewBlock view;
    view.eye_seconds = {eye, 0};
    view.haze_colour.w = 0;
    view.mist = {1.442695F * 0.006F, level_m, 1.442695F / depth_m, 20};
    return view;
}

// The formula against a sum along the ray.
TEST(Mist, HidesWhatTheIntegralOfItsDensityHides) {
    base::RandomStream random{base::Seed{8}};
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 eye{0, random.between(0, 90), 0};
        const glm::vec3 at{random.between(-400, 400), random.between(0, 120), random.between(-400, 400)};
        const float level = random.between(0, 50);
        const float depth = random.between(4, 36);
        double sum = 0;
        constexpr int kSteps = 4000;
        for (int k = 0; k < kSteps; ++k) {
            const double y = eye.y + (at.y - eye.y) * (k + 0.5) / kSteps;
            sum += std::exp(-std::max(y - level, 0.0) / depth) / kSteps;
        }
        const double hidden = 1 - std::exp(-0.006 * glm::distance(eye, at) * sum);
        EXPECT_NEAR(haze_at(misty(level, depth, eye), at).a, hidden, 0.012) << eye.y << " " << at.y << " " << level;
    }
}

TEST(Mist, LiesOnTheFloorOfItsSceneHoweverHighThatIs) {
    const auto hidden = [](float floor_m, glm::vec3 eye_m, glm::vec3 at_m) {
        auto scene = std::make_shared<GpuScene>();
        scene->air.sky.mist = {0.006F, 10, 14};
        scene->air.sky.haze_distance_m = 1e9F;  // which keeps to the sea
        scene->air.floor_m = floor_m;
        View view;
        view.scene = scene;
        view.viewport = {0, 0, 160, 90};
        const glm::vec3 up{0, floor_m, 0};
        view.camera.eye_m = eye_m + up;
        return haze_at(block_of(view, glm::mat4{1}, 0), at_m + up).a;
    };
    base::RandomStream random{base::Seed{4}};
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 eye_m{0, random.between(2, 30), 0};
        const glm::vec3 at_m{random.between(-300, 300), random.between(0, 40), random.between(-300, 300)};
        EXPECT_NEAR(hidden(100, eye_m, at_m), hidden(0, eye_m, at_m), 1e-3F);
    }
    EXPECT_GT(hidden(100, {0, 3, 0}, {0, 2, -300}), 0.5F);
}

TEST(CloudShadow, GoesWithTheWind) {
    mesh::Image density(64, 64, 1);
    base::RandomStream random{base::Seed{2}};
    for (std::uint8_t& b : density.bytes) b = static_cast<std::uint8_t>(random.below(256));
    ViewBlock view;
    view.shadow_turn = {0.001F, 0.0004F, -0.0004F, 0.001F};
    view.shadow_place = {0.3F, 0.7F, 0.0002F, 0.0001F};
    view.cloud_place[0].z = 0.6F;
    ViewBlock later = view;
    const glm::vec2 moved{70, -30};  // metres that the clouds have gone
    later.shadow_place.x -= view.shadow_turn.x * moved.x + view.shadow_turn.z * moved.y;
    later.shadow_place.y -= view.shadow_turn.y * moved.x + view.shadow_turn.w * moved.y;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 at{random.between(-500, 500), random.between(0, 80), random.between(-500, 500)};
        const float before = cloud_light_at(view, density, at);
        EXPECT_NEAR(cloud_light_at(later, density, at + glm::vec3{moved.x, 0, moved.y}), before, 0.02F);
        EXPECT_GE(before, 0.39F);
        EXPECT_LE(before, 1.0F);
    }
    EXPECT_EQ(cloud_light_at(view, {}, {0, 0, 0}), 1);
}

TEST(CloudShadow, MapKeepsTheMeanOfItsClouds) {
    mesh::Image density(512, 512, 1);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) *density.pixel(x, y) = static_cast<std::uint8_t>((x / 64 + y / 64) % 2 * 200);
    const mesh::Image map = passes::shadow_map_of(density);
    ASSERT_EQ(map.width, passes::kShadowSide);
    double sum = 0;
    for (const std::uint8_t b : map.bytes) sum += b;
    EXPECT_NEAR(sum / static_cast<double>(map.bytes.size()), 100, 1);
}

}  // namespace
}  // namespace quadrat::render::choose
