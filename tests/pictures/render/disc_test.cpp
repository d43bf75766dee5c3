// SPDX-License-Identifier: Apache-2.0
// The sun's disc is round, wherever it stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"

namespace quadrat::tests {
namespace {

class SunDisc : public Stage {
  protected:
    mesh::Image drawn(scene::Scene scene, float up, bool has_disc) {
        auto sky = std::make_shared<scene::Sky>(*scene.sky);
        sky->sun_direction = sky->glow_direction = glm::vec3{0, up, -std::sqrt(1 - up * up)};
        sky->dome = scene::Dome{};
        sky->glare = glm::vec3{0};
        sky->disc.colour = glm::vec3{1};
        sky->disc.radius_rad = 0.07F;
        if (!has_disc) sky->disc.picture = mesh::Image{};
        for (scene::CloudLayer& layer : sky->clouds) layer.opacity = 0;
        scene.sky = sky;
        render::View view;
        view.scene = uploaded(std::make_shared<scene::Scene>(std::move(scene)));
        view.camera.eye_m = {0, 80, 0};
        view.camera.target_m = view.camera.eye_m + 100.0F * sky->sun_direction;
        render::Frame f = frame();
        view.viewport = {0, 0, f.size.x, f.size.y};
        f.views = {view};
        renderer_->draw(f);
        return renderer_->read_pixels(f);
    }
};

TEST_F(SunDisc, IsAsWideAsHighNearTheHorizonToo) {
    for (const float up : {0.13F, 0.25F, 0.6F}) {
        const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
        const mesh::Image with = drawn(*scene, up, true);
        const mesh::Image without = drawn(*scene, up, false);
        glm::ivec2 low{with.width, with.height};
        glm::ivec2 high{-1, -1};
        int lit = 0;
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x) {
                if (std::abs(with.pixel(x, y)[0] - without.pixel(x, y)[0]) < 20) continue;
                low = {std::min(low.x, x), std::min(low.y, y)};
                high = {std::max(high.x, x), std::max(high.y, y)};
                ++lit;
            }
        const glm::ivec2 size = high - low + 1;
        ASSERT_GT(size.x, 20) << up;
        EXPECT_LE(std::abs(size.x - size.y), 2) << up;
        // As full as a circle: an egg has corners to spare.
        EXPECT_NEAR(lit / (0.7854 * size.x * size.y), 1.0, 0.06) << up;
        EXPECT_NEAR(0.5F * static_cast<float>(low.y + high.y), 0.5F * static_cast<float>(with.height), 2.0F) << up;
    }
}

}  // namespace
}  // namespace quadrat::tests
