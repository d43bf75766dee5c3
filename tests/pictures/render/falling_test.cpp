// SPDX-License-Identifier: Apache-2.0
// Rain and snow in less detail: fewer drops, and as bright a picture.
#include <gtest/gtest.h>

#include <cmath>

#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"

namespace quadrat::tests {
namespace {

class FallingDrops : public Stage {
  protected:
    // What falls before a dark sky, without the land: so much brighter is the picture.
    struct Seen {
        std::size_t triangles = 0;
        double light = 0;  // mean of all bytes but alpha
    };
    Seen seen(const std::shared_ptr<const render::GpuScene>& scene, const scene::Camera& camera, float alpha) {
        render::Frame f = frame();
        f.detail.alpha = alpha;
        f.measured = {false, false, false, false, true};
        render::View view;
        view.scene = scene;
        view.camera = camera;
        view.viewport = {0, 0, f.size.x, f.size.y};
        f.views = {view};
        const render::Drawn drawn = renderer_->draw(f);
        const mesh::Image picture = renderer_->read_pixels(f);
        Seen seen;
        seen.triangles = drawn.of[static_cast<std::size_t>(render::DrawnKind::Falling)].triangles;
        for (std::size_t i = 0; i < picture.bytes.size(); ++i)
            if (i % 4 != 3) seen.light += picture.bytes[i];
        seen.light /= 0.75 * static_cast<double>(picture.bytes.size());
        return seen;
    }
    void expect_as_bright(Hour hour) {
        scene::Scene falling = *handmade_scene(hour, Ground::Meadow);
        auto sky = std::make_shared<scene::Sky>(*falling.sky);
        sky->dome = scene::Dome{};
        sky->haze_colour = sky->haze_sunward = glm::vec3{0};
        for (scene::CloudLayer& layer : sky->clouds) layer.opacity = 0;
        falling.sky = sky;
        auto cold = std::make_shared<scene::Land>(*falling.land);
        cold->snow_line_m = 0;  // on other land no snow falls
        falling.land = cold;
        scene::Scene dry = falling;
        auto dry_sky = std::make_shared<scene::Sky>(*sky);
        dry_sky->precipitation = {};
        dry.sky = dry_sky;
        const scene::Camera camera = falling.track.cameras.front();
        const auto wet_scene = uploaded(std::make_shared<scene::Scene>(std::move(falling)));
        const auto dry_scene = uploaded(std::make_shared<scene::Scene>(std::move(dry)));
        const double background = seen(dry_scene, camera, 1).light;
        const Seen all = seen(wet_scene, camera, 1);
        const double added = all.light - background;
        ASSERT_GT(added, 0.5);
        for (const float alpha : {0.25F, 0.1F, 0.01F}) {
            const Seen some = seen(wet_scene, camera, alpha);
            const double share = std::max(std::sqrt(static_cast<double>(alpha)), 0.25);
            EXPECT_NEAR(static_cast<double>(some.triangles), share * static_cast<double>(all.triangles), 4) << alpha;
            EXPECT_NEAR(some.light - background, added, 0.1 * added) << alpha;
            EXPECT_NEAR(some.light, all.light, 0.02 * 255) << alpha;
        }
        EXPECT_EQ(seen(wet_scene, camera, 4).triangles, all.triangles);
    }
};

TEST_F(FallingDrops, OfRainAreFewerInLessDetailAndAsBright) { expect_as_bright(Hour::Storm); }

TEST_F(FallingDrops, OfSnowAreFewerInLessDetailAndAsBright) { expect_as_bright(Hour::Snow); }

TEST_F(FallingDrops, OfSnowAreNoneWhereTheLineOfSnowIsFarAbove) {
    scene::Scene scene = *handmade_scene(Hour::Snow, Ground::Meadow);
    const scene::Camera camera = scene.track.cameras.front();
    for (const bool is_cold : {true, false}) {
        auto land = std::make_shared<scene::Land>(*scene.land);
        land->snow_line_m = scene.floor_m + (is_cold ? 90.0F : 200.0F);
        scene.land = land;
        EXPECT_EQ(seen(uploaded(std::make_shared<scene::Scene>(scene)), camera, 1).triangles > 0, is_cold);
    }
}

}  // namespace
}  // namespace quadrat::tests
