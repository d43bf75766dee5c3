// SPDX-License-Identifier: Apache-2.0
#include "render/glimpse.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"

namespace quadrat::tests {
namespace {

class Glimpses : public Stage {
  protected:
    render::Frame noon() {
        const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
        render::View view;
        view.scene = uploaded(scene);
        view.camera = scene->track.cameras.front();
        view.viewport = {0, 0, 640, 360};
        render::Frame f = frame();
        f.views = {view};
        return f;
    }
    // As the frames to come would; how many that were.
    int await(std::optional<mesh::Image>& picture) {
        int frames = 0;
        for (; !picture && frames < 1000; ++frames) {
            renderer_->finish();
            picture = glimpse_->take();
        }
        return frames;
    }
    void TearDown() override {
        glimpse_.reset();
        Stage::TearDown();
    }

    std::optional<render::Glimpse> glimpse_{std::in_place};
};

TEST_F(Glimpses, OfTheFramesOwnSizeIsTheFrameItself) {
    const render::Frame f = noon();
    const mesh::Image whole = drawn(f);
    ASSERT_TRUE(glimpse_->begin(f, 4000));
    EXPECT_FALSE(glimpse_->begin(f, 4000)) << "one is on its way";
    std::optional<mesh::Image> picture;
    const int frames = await(picture);
    ASSERT_TRUE(picture);
    EXPECT_GT(frames, 4) << "it comes in slices";
    ASSERT_EQ(picture->width, 640);
    ASSERT_EQ(picture->height, 360);
    for (int y = 0; y < 360; y += 7)
        for (int x = 0; x < 640; x += 11)
            for (int c = 0; c < 3; ++c) ASSERT_EQ(picture->pixel(x, y)[c], whole.pixel(x, y)[c]) << x << ", " << y;
    EXPECT_FALSE(glimpse_->take()) << "once";
}

TEST_F(Glimpses, AreSmallerAndLookAlike) {
    const render::Frame f = noon();
    const mesh::Image whole = drawn(f);
    for (const int width : {320, 160, 320}) {
        ASSERT_TRUE(glimpse_->begin(f, width));
        std::optional<mesh::Image> picture;
        await(picture);
        ASSERT_TRUE(picture);
        ASSERT_EQ(picture->width, width);
        ASSERT_EQ(picture->height, width * 9 / 16);
        double apart = 0;
        const int by = 640 / width;
        for (int y = 0; y < picture->height; ++y)
            for (int x = 0; x < width; ++x)
                apart += std::abs(picture->pixel(x, y)[1] - whole.pixel(by * x + by / 2, by * y + by / 2)[1]);
        EXPECT_LT(apart / (picture->height * width), 8) << "of 255, in the mean";
    }
}

TEST_F(Glimpses, OfNothingAreNone) {
    EXPECT_FALSE(glimpse_->take());
    render::Frame f = frame();
    f.size = {0, 0};
    EXPECT_FALSE(glimpse_->begin(f, 854));
}

}  // namespace
}  // namespace quadrat::tests
