// SPDX-License-Identifier: Apache-2.0
// The ground hides what is behind it: at any detail, from anywhere over it, every pixel below the horizon is ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "nursery/growing.hpp"
#include "stage/easel.hpp"
#include "support/effort.hpp"

namespace quadrat::stage {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr std::size_t kScenes = 4;
constexpr std::size_t kCameras = 500;  // over each; by ROAM a quarter of them

scene::Camera somewhere_over(const scene::Land& land, base::RandomStream& chance) {
    const auto across = [&] { return (chance.unit_f() - 0.5F) * 0.9F * land.side_m(); };
    scene::Camera camera;
    camera.eye_m = {across(), 0, across()};
    camera.eye_m.y = std::max(scene::ground_height_m(land, {camera.eye_m.x, camera.eye_m.z}), 0.0F) + 1.5F +
                     60 * chance.unit_f() * chance.unit_f();
    const float azimuth = glm::radians(360 * chance.unit_f());
    const float down = glm::radians(4 + 40 * chance.unit_f());
    camera.target_m = camera.eye_m + glm::vec3{std::sin(azimuth) * std::cos(down), -std::sin(down),
                                               -std::cos(azimuth) * std::cos(down)};
    return camera;
}

// The elevation below which every ray meets the country around the land, if nothing before it.
float surely_ground_rad(const scene::Land& land, const scene::Camera& camera) {
    const float half_m = 0.5F * land.surround_cell_m * static_cast<float>(land.surround_m.columns - 1);
    const float near_m = half_m - std::max(std::abs(camera.eye_m.x), std::abs(camera.eye_m.z));
    const float lowest_m = std::ranges::min(land.surround_m.samples);
    return std::atan2(std::min(lowest_m - camera.eye_m.y, 0.0F), near_m);
}

// The highest row from the bottom of the picture whose pixels all look lower than that.
int rows_below(const scene::Camera& camera, float elevation_rad) {
    const glm::vec3 ahead = glm::normalize(camera.target_m - camera.eye_m);
    const glm::vec3 aside = glm::normalize(glm::cross(ahead, glm::vec3{0, 1, 0}));
    const glm::vec3 up = glm::cross(aside, ahead);
    const float half = std::tan(glm::radians(camera.vertical_fov_deg) / 2);
    for (int row = kHeight - 1; row >= 0; --row) {
        float highest = -1;
        for (const float x : {-1.0F, 0.0F, 1.0F}) {
            const float y = (static_cast<float>(row) + 1) * 2 / kHeight - 1;
            const glm::vec3 ray = glm::normalize(ahead + up * (y * half) + aside * (x * half * kWidth / kHeight));
            highest = std::max(highest, std::asin(ray.y));
        }
        if (highest < elevation_rad) return row + 1;
    }
    return 0;
}

void expect_no_cracks(render::GroundBy ground, std::size_t cameras) {
    Easel easel(kWidth, kHeight, ground);
    long looked_at = 0;
    for (std::size_t s = 0; s < kScenes; ++s) {
        const std::shared_ptr<const scene::Scene> grown = nursery::grow(genome::random_recipe(base::Seed{21}.child(s)));
        base::RandomStream chance{base::Seed{77}.child(s)};
        render::Frame frame;
        frame.size = {kWidth, kHeight};
        frame.measured = {false, false, true, false, false, true};
        render::View view;
        view.scene = upload_now(easel.renderer(), grown);
        view.viewport = {0, 0, kWidth, kHeight};
        frame.views = {view};
        const scene::Land& land = *grown->land;
        for (std::size_t n = 0; n < cameras; ++n) {
            frame.views[0].camera = somewhere_over(land, chance);
            frame.detail.alpha = std::exp2(5 * chance.unit_f() - 3);
            frame.framebuffer = easel.display().begin_frame().framebuffer;
            easel.renderer().draw(frame);
            const mesh::Image pixels = easel.renderer().read_pixels(frame);
            easel.display().present();
            const int rows = rows_below(frame.views[0].camera, surely_ground_rad(land, frame.views[0].camera));
            for (int row = kHeight - rows; row < kHeight; ++row) {
                for (int x = 0; x < kWidth; ++x) {
                    // As drawn, a pixel counts how often ground was drawn on it.
                    ASSERT_GT(pixels.pixel(x, row)[3], 0)
                        << "scene " << s << ", camera " << n << ", pixel " << x << ", " << row;
                    ++looked_at;
                }
            }
        }
    }
    EXPECT_GT(looked_at, static_cast<long>(kScenes * cameras) * kWidth * kHeight / 3);
}

TEST(Cracks, NoPixelBelowTheHorizonShowsWhatIsBehindTheGround) {
    expect_no_cracks(render::GroundBy::Blocks, tests::of(kCameras));
}

TEST(Cracks, NorDoesOneOfGroundByRoamWhoseEyeJumps) {
    expect_no_cracks(render::GroundBy::Roam, tests::of(kCameras / 4));
}

}  // namespace
}  // namespace quadrat::stage
