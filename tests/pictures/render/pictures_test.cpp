// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "pictures/golden.hpp"
#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"
#include "render/gl/texture.hpp"
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
    // Only these parts of it.
    mesh::Image parts(const std::shared_ptr<const scene::Scene>& scene, const render::Measured& measured) {
        render::Frame f = frame();
        render::View view;
        view.scene = uploaded(scene);
        view.camera = scene->track.cameras.front();
        view.viewport = {0, 0, 640, 360};
        f.views = {view};
        f.measured = measured;
        return drawn(f);
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

// How far a picture's pixels are from grey, on the mean, where anything was drawn: nothing is in its corner.
double colourfulness(const mesh::Image& picture) {
    double sum = 0;
    double drawn = 0;
    for (std::size_t i = 0; i + 3 < picture.bytes.size(); i += 4) {
        if (std::equal(&picture.bytes[i], &picture.bytes[i] + 3, picture.bytes.data())) continue;
        const auto [low, high] = std::minmax({picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]});
        sum += high - low;
        ++drawn;
    }
    return sum / std::max(drawn, 1.0);
}

TEST_F(Pictures, OfADarkNightHaveLessColourInAllThatIsLit) {
    const auto by_day = handmade_scene(Hour::Noon, Ground::Meadow);
    scene::Scene dark = *by_day;
    auto sky = std::make_shared<scene::Sky>(*by_day->sky);
    sky->darkness = 1;  // in the same light
    dark.sky = sky;
    const auto colourful = [&](const std::shared_ptr<const scene::Scene>& scene, bool leaves, bool wood, bool ground) {
        return colourfulness(parts(scene, {leaves, wood, ground, false, false}));
    };
    const auto by_night = std::make_shared<const scene::Scene>(dark);
    for (int part = 0; part < 3; ++part) {
        const double day = colourful(by_day, part == 0, part == 1, part == 2);
        ASSERT_GT(day, 5) << part;
        EXPECT_LT(colourful(by_night, part == 0, part == 1, part == 2), 0.85 * day) << part;
    }
}

// What is as light as snow and as grey.
int white_pixels(const mesh::Image& picture) {
    int count = 0;
    for (std::size_t i = 0; i + 3 < picture.bytes.size(); i += 4) {
        const auto [low, high] = std::minmax({picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]});
        if (low > 150 && high - low < 50) ++count;
    }
    return count;
}

TEST_F(Pictures, AboveTheSnowLinePlantsHaveSnowOnThem) {
    const auto with_snow_from = [&](float line_m) {
        scene::Scene scene = *handmade_scene(Hour::Noon, Ground::Meadow);
        auto land = std::make_shared<scene::Land>(*scene.land);
        land->snow_line_m = line_m;
        scene.land = land;
        return std::make_shared<const scene::Scene>(scene);
    };
    const auto snowy = with_snow_from(-100);
    const auto bare = with_snow_from(1.0e6F);
    const render::Measured leaves{true, false, false, false, false};
    EXPECT_GT(white_pixels(parts(snowy, leaves)), white_pixels(parts(bare, leaves)) + 100);
}

TEST_F(Pictures, AStormLooksAsItDid) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Storm, Ground::Meadow, {0, 0, 640, 360})};
    expect_golden("storm", drawn(f));
}

TEST_F(Pictures, SnowfallLooksAsItDid) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Snow, Ground::Meadow, {0, 0, 640, 360})};
    expect_golden("snow", drawn(f));
}

TEST_F(Pictures, FogLooksAsItDid) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Fog, Ground::Meadow, {0, 0, 640, 360})};
    expect_golden("fog", drawn(f));
}

// Half the triangles, as on a Raspberry Pi 4 that is short of time.
TEST_F(Pictures, FourViewsAtARaspberryPisDetailLookAsTheyDid) {
    render::Frame f = frame();
    f.detail.alpha = 0.5F;
    f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 180, 320, 180}),
               view_of(Hour::Sunset, Ground::Desert, {320, 180, 320, 180}),
               view_of(Hour::Fog, Ground::Meadow, {0, 0, 320, 180}),
               view_of(Hour::Storm, Ground::Meadow, {320, 0, 320, 180})};
    expect_golden("raspberry_pi", drawn(f));
}

// It is a ring of 38.6 to 54.6 degrees about the point opposite the sun, and nothing else of the picture changes.
TEST_F(Pictures, ARainbowStandsOppositeTheSun) {
    auto scene = *handmade_scene(Hour::Sunset, Ground::Meadow);
    auto with = std::make_shared<scene::Sky>(*scene.sky);
    auto without = std::make_shared<scene::Sky>(*scene.sky);
    with->bow = 1;
    without->bow = 0;
    const glm::vec3 away = -glm::normalize(glm::vec3{with->sun_direction.x, 0, with->sun_direction.z});
    render::View view;
    view.viewport = {0, 0, 640, 360};
    view.camera.eye_m = {0, 60, 0};
    view.camera.target_m = view.camera.eye_m + away + glm::vec3{0, 0.5F, 0};
    view.camera.vertical_fov_deg = 70;
    const auto drawn_with = [&](const std::shared_ptr<scene::Sky>& sky) {
        auto changed = std::make_shared<scene::Scene>(scene);
        changed->sky = sky;
        view.scene = uploaded(changed);
        render::Frame f = frame();
        f.views = {view};
        return drawn(f);
    };
    const mesh::Image a = drawn_with(with);
    const mesh::Image b = drawn_with(without);
    const glm::mat4 world_from_clip =
        glm::inverse(scene::clip_from_view(view.camera, 640.0F / 360.0F) * scene::view_from_world(view.camera));
    int changed = 0;
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 640; ++x) {
            int difference = 0;
            for (int c = 0; c < 3; ++c)
                difference = std::max(difference, std::abs(int{a.pixel(x, y)[c]} - int{b.pixel(x, y)[c]}));
            if (difference < 4) continue;
            ++changed;
            const glm::vec4 far = world_from_clip * glm::vec4{(static_cast<float>(x) + 0.5F) / 320 - 1,
                                                              1 - (static_cast<float>(y) + 0.5F) / 180, 1, 1};
            const glm::vec3 ray = glm::normalize(glm::vec3{far} / far.w - view.camera.eye_m);
            const float apart = glm::degrees(std::acos(glm::dot(ray, -with->sun_direction)));
            EXPECT_GT(apart, 38.0F);
            EXPECT_LT(apart, 55.5F);
        }
    }
    EXPECT_GT(changed, 2000);
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

// How far pictures lie from each other, in levels of a channel, and whether that part is the same.
double mean_difference(const mesh::Image& a, const mesh::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(int{a.bytes[i]} - int{b.bytes[i]});
    return sum / static_cast<double>(a.bytes.size());
}

TEST_F(Pictures, ViewsThatAreDrawnSmallerLookAlikeAndSignsStaySharp) {
    render::Frame f = frame();
    f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 0, 318, 360}),
               view_of(Hour::Sunset, Ground::Desert, {322, 0, 318, 360})};
    render::Sign bar;
    bar.place = {0, 300, 640, 60};
    bar.colour = {0.05F, 0.06F, 0.08F, 1};
    const auto text = render::letter("A B C D", {.size_px = 26, .is_bold = true});
    f.signs = {bar, picture_sign(text, 40, 315)};
    const mesh::Image whole = drawn(f);
    const std::size_t sign_bytes = static_cast<std::size_t>(640) * 60 * 4;  // the picture's upper rows
    for (const float scale : {0.8F, 0.5F}) {
        f.detail.scale = scale;
        const mesh::Image smaller = drawn(f);
        EXPECT_LT(mean_difference(whole, smaller), 4) << scale;
        EXPECT_GT(mean_difference(whole, smaller), 0.1) << scale;
        EXPECT_TRUE(std::equal(whole.bytes.begin(), whole.bytes.begin() + static_cast<std::ptrdiff_t>(sign_bytes),
                               smaller.bytes.begin()))
            << scale;
    }
    f.detail.scale = 1;
    EXPECT_EQ(drawn(f).bytes, whole.bytes) << "nothing of it is left behind";
}

TEST_F(Pictures, SeveralSamplesAPixelAreNearerToAPictureOfTwiceTheSize) {
    render::Frame f = frame();
    f.detail.alpha = 100;  // or what is larger on the screen is drawn more closely
    const auto two_views = [&](int times) {
        f.size = {640 * times, 360 * times};
        f.framebuffer = canvas_.framebuffer;
        f.views = {view_of(Hour::Noon, Ground::Meadow, {0, 0, 318 * times, 360 * times}),
                   view_of(Hour::Sunset, Ground::Desert, {322 * times, 0, 318 * times, 360 * times})};
    };
    two_views(1);
    const mesh::Image rough = drawn(f);
    f.detail.samples = 4;
    EXPECT_EQ(renderer_->draw(f).samples, 4);
    const mesh::Image smooth = renderer_->read_pixels(f);
    f.detail.samples = 1;
    EXPECT_EQ(renderer_->draw(f).samples, 1);
    EXPECT_EQ(renderer_->read_pixels(f).bytes, rough.bytes) << "nothing of it is left behind";
    f.views.clear();
    open({1280, 720});
    two_views(2);
    const mesh::Image reference = render::gl::halved(drawn(f));
    EXPECT_LT(mean_difference(smooth, reference), 0.7 * mean_difference(rough, reference));
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
