// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <utility>

#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"

namespace quadrat::tests {
namespace {

class GroundPicture : public Stage {};

// What is brought ahead, in whatever pieces, makes the same picture.
TEST_F(GroundPicture, AGroundBroughtAheadIsTheSame) {
    const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
    render::Frame f = frame();
    const auto picture_of = [&](std::shared_ptr<const render::GpuScene> gpu) {
        f.views = {{std::move(gpu), scene->track.cameras.front(), {0, 0, f.size.x, f.size.y}, 1, 0}};
        return drawn(f);
    };
    const mesh::Image at_once = picture_of(uploaded(scene));
    f.views.clear();
    const auto ahead = renderer_->begin_upload(scene::Ground{scene->flora, scene->land});
    ahead->prepare();
    int pieces = 0;
    while (!ahead->advance(1)) ++pieces;
    EXPECT_GT(pieces, 8);
    const auto rest = renderer_->begin_upload(scene);
    int left = 0;
    while (!rest->advance(1)) ++left;
    EXPECT_LT(left, pieces + 16);
    EXPECT_EQ(picture_of(rest->take()), at_once);
}

TEST_F(GroundPicture, AnUploadStopsWhenItsTimeIsOver) {
    const auto upload = renderer_->begin_upload(handmade_scene(Hour::Noon, Ground::Meadow));
    upload->prepare();
    int steps = 0;
    while (!upload->advance(static_cast<std::size_t>(-1), [] { return false; })) ++steps;
    EXPECT_GT(steps, 10);
}

// Whatever else a scene's sky has: under the sun that its land is lit by already, the grain is there.
TEST_F(GroundPicture, OneSunLightsTheGrainOnce) {
    const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
    const auto first = uploaded(scene);
    const auto pieces_under = [&](float turn) {
        auto sky = std::make_shared<scene::Sky>(*scene->sky);
        sky->sun_direction = glm::normalize(sky->sun_direction + glm::vec3{turn, 0, 0});
        auto other = std::make_shared<scene::Scene>(*scene);
        other->sky = sky;
        const auto upload = renderer_->begin_upload(other);
        int pieces = 0;
        while (!upload->advance(1)) ++pieces;
        return std::pair{pieces, upload->take()};
    };
    const auto [same, again] = pieces_under(0);
    const auto [turned, other] = pieces_under(0.3F);
    EXPECT_LT(same, turned);
    render::Frame f = frame();
    const auto picture_of = [&](std::shared_ptr<const render::GpuScene> gpu) {
        f.views = {{std::move(gpu), scene->track.cameras.front(), {0, 0, f.size.x, f.size.y}, 1, 0}};
        return drawn(f);
    };
    const mesh::Image at_once = picture_of(first);
    EXPECT_EQ(picture_of(again), at_once);
    EXPECT_NE(picture_of(other), at_once);
}

}  // namespace
}  // namespace quadrat::tests
