// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"
#include "render/lettering.hpp"

namespace quadrat::tests {
namespace {

using render::Rect;

class Pictures : public Stage {
  protected:
    render::View view_of(Hour hour, Ground ground, Rect place) {
        const auto scene = handmade_scene(hour, ground);
        render::View view;
        view.scene = uploaded(scene);
        view.camera = scene->track.cameras.front();
        view.viewport = place;
        return view;
    }
    render::Sign picture_sign(const mesh::Image& image, int x, int y) {
        render::Sign sign;
        sign.texture = renderer_->texture(image);
        sign.place = {x, y, image.width, image.height};
        return sign;
    }
};

TEST_F(Pictures, ASceneAtNoonLooksAsItDid) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 0, 640, 360})};
    expect_golden("noon", drawn(f));
}

TEST_F(Pictures, ASceneAtSunsetLooksAsItDid) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Sunset, Ground::Meadow, {0, 0, 640, 360})};
    expect_golden("sunset", drawn(f));
}

TEST_F(Pictures, ASceneAtNightStaysReadable) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Night, Ground::Meadow, {0, 0, 640, 360})};
    const mesh::Image picture = drawn(f);
    expect_golden("night", picture);
    const auto brightest = *std::ranges::max_element(picture.bytes.begin(), picture.bytes.end());
    EXPECT_GT(brightest, 100);
}

TEST_F(Pictures, FourViewsEachStayInTheirQuarter) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 180, 320, 180}),
               view_of(Hour::Sunset, Ground::Desert, {320, 180, 320, 180}),
               view_of(Hour::Noon, Ground::Desert, {0, 0, 320, 180}),
               view_of(Hour::Night, Ground::Meadow, {320, 0, 320, 180})};
    f.views[2].dim = 1;
    expect_golden("four_views", drawn(f));
}

TEST_F(Pictures, AnArrivingGenerationStandsAsSaplings) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 0, 640, 360})};
    f.views[0].growth = 0.3F;
    expect_golden("growth_0_3", drawn(f));
}

TEST_F(Pictures, SignsLieOverTheViews) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Sunset, Ground::Desert, {0, 0, 640, 360})};
    render::Sign bar;
    bar.place = {0, 0, 640, 64};
    bar.colour = {0.05F, 0.06F, 0.08F, 0.75F};
    render::Sign frame_line;
    frame_line.place = {12, 80, 300, 268};
    frame_line.colour = {0.9F, 0.62F, 0.0F, 1};
    frame_line.border_px = 6;
    frame_line.corner_radius_px = 14;
    const auto text = render::letter("Welche Bäume gefallen dir am besten?", {.size_px = 26, .is_bold = true});
    f.signs = {bar, frame_line, picture_sign(text, (640 - text.width) / 2, 32 - text.height / 2)};
    const glm::vec4 colours[4] = {
        {0.90F, 0.62F, 0.0F, 1}, {0.34F, 0.71F, 0.91F, 1}, {0.0F, 0.62F, 0.45F, 1}, {0.94F, 0.89F, 0.26F, 1}};
    for (int i = 0; i < 4; ++i) {
        const auto badge =
            render::badge(static_cast<render::Shape>(i), std::string(1, static_cast<char>('A' + i)), colours[i], 84);
        f.signs.push_back(picture_sign(badge, 330 + 72 * i, 250));
    }
    expect_golden("signs", drawn(f));
}

}  // namespace
}  // namespace quadrat::tests
