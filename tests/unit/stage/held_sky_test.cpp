// SPDX-License-Identifier: Apache-2.0
// The sky of frames that follow each other is a picture of some frames ago, moved: it looks as if it were drawn anew.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "stage/easel.hpp"

namespace quadrat::stage {
namespace {

constexpr glm::ivec2 kSize{640, 360};

using SceneOf = std::shared_ptr<const scene::Scene>;

// Nothing but sky, the eye 30 m above the land.
scene::Camera looking_up(const scene::Scene& scene, float seconds) {
    scene::Camera camera = scene::camera_at(scene.track, seconds);
    camera.eye_m.y += 30;
    camera.target_m.y += 30 + 0.2F * glm::distance(camera.eye_m, camera.target_m);
    return camera;
}

struct Moment {
    SceneOf scene;
    scene::Camera camera;
    float seconds = 0;
    float dim = 0;
    float scale = 1;
    float alpha = 1;
};

struct Shown {
    mesh::Image pixels;
    std::size_t triangles = 0;
};

std::vector<Shown> shown(const std::vector<Moment>& moments, const render::Hanging& hanging, bool is_one_of_many) {
    Easel easel(kSize.x, kSize.y);
    std::map<SceneOf, std::shared_ptr<const render::GpuScene>> uploaded;
    std::vector<Shown> all;
    for (const Moment& moment : moments) {
        auto& scene = uploaded[moment.scene];
        if (!scene) scene = upload_now(easel.renderer(), moment.scene);
        const display::Canvas canvas = easel.display().begin_frame();
        render::Frame frame;
        frame.framebuffer = canvas.framebuffer;
        frame.size = render::turned_size(kSize, hanging);
        frame.hanging = hanging;
        frame.measured = {false, false, false, false, true};
        frame.seconds = moment.seconds;
        frame.detail = {moment.alpha, moment.scale};
        frame.is_one_of_many = is_one_of_many;
        frame.views.push_back({scene, moment.camera, {0, 0, frame.size.x, frame.size.y}, 1, moment.dim});
        const std::size_t triangles = easel.renderer().draw(frame).triangles;
        all.push_back({easel.renderer().read_pixels(frame), triangles});
        easel.display().present();
    }
    return all;
}

// Mean over colours and pixels, in steps of 255.
double difference(const Shown& a, const Shown& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.bytes.size(); ++i) sum += std::abs(a.pixels.bytes[i] - b.pixels.bytes[i]);
    return sum / static_cast<double>(a.pixels.bytes.size());
}

constexpr double kUnseen = 0.7;  // clouds are held coarser than they are shown

TEST(HeldSky, LooksAsIfItWereDrawnAnew) {
    for (const std::uint64_t seed : {5, 21}) {
        const SceneOf scene = nursery::grow(genome::random_recipe(base::Seed{seed}), {65, 64, 128});
        std::vector<Moment> moments;
        for (int n = 0; n < 12; ++n) {
            const float seconds = 20 + static_cast<float>(n) / 15;
            moments.push_back({scene, looking_up(*scene, seconds), seconds});
        }
        for (const render::Hanging hanging : {render::Hanging{0, false}, render::Hanging{1, true}}) {
            const auto held = shown(moments, hanging, true);
            const auto whole = shown(moments, hanging, false);
            std::size_t reused = 0;
            for (std::size_t n = 0; n < moments.size(); ++n) {
                EXPECT_LT(difference(held[n], whole[n]), kUnseen) << seed << " after " << n;
                if (held[n].triangles < whole[n].triangles) ++reused;
            }
            EXPECT_GE(reused, moments.size() / 2) << seed;
        }
    }
}

TEST(HeldSky, MovesWithItsClouds) {
    const SceneOf calm = nursery::grow(genome::random_recipe(base::Seed{5}), {65, 64, 128});
    auto sky = std::make_shared<scene::Sky>(*calm->sky);
    sky->cloudscape = {};  // the layer as it is
    sky->clouds[0].wind_m_s = {400, 100};
    sky->clouds[0].height_m = 500;
    sky->clouds[0].opacity = 0.9F;
    sky->clouds[1].opacity = 0;
    mesh::Image squares(64, 64, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) *squares.pixel(x, y) = (x / 8 + y / 8) % 2 == 0 ? 255 : 0;
    sky->clouds[0].density = sky->clouds[0].lit = squares;
    sky->clouds[0].mean_density = 0.5F;
    sky->clouds[0].tile_m = 700;
    sky->precipitation.kind = scene::Precipitation::Kind::None;
    auto windy = std::make_shared<scene::Scene>(*calm);
    windy->sky = sky;
    scene::Camera up = looking_up(*windy, 0);
    up.target_m.y += glm::distance(up.eye_m, up.target_m);
    std::vector<Moment> moments;
    for (int n = 0; n < 12; ++n) moments.push_back({windy, up, 18 + static_cast<float>(n) / 15});
    const auto held = shown(moments, {}, true);
    const auto whole = shown(moments, {}, false);
    for (std::size_t n = 3; n < moments.size(); ++n) {
        EXPECT_LT(difference(held[n], whole[n]), 1.6 * kUnseen) << n << ": squares have sharp edges";
        EXPECT_GT(difference(whole[n - 3], whole[n]), 2 * kUnseen) << "as it would be, standing still";
    }
}

// In its sky's own light: what a camera opens for a dark land makes every difference larger, those of resampling too.
SceneOf grown_as_its_sky_is(std::uint64_t seed) {
    auto scene = std::make_shared<scene::Scene>(*nursery::grow(genome::random_recipe(base::Seed{seed}), {65, 64, 128}));
    scene->exposure = std::min(scene->exposure, 1.0F);
    return scene;
}

TEST(HeldSky, IsDrawnAnewWhereTheEyeTurnsAwayTimeJumpsOrAnotherSceneComes) {
    const SceneOf scene = grown_as_its_sky_is(3);
    const SceneOf next = grown_as_its_sky_is(4);
    Moment moment{scene, looking_up(*scene, 0)};
    std::vector<Moment> changes{moment};
    const glm::vec3 ahead = moment.camera.target_m - moment.camera.eye_m;
    moment.camera.target_m = moment.camera.eye_m + glm::vec3{-ahead.x, ahead.y, -ahead.z};
    changes.push_back(moment);
    moment.seconds = 600;
    changes.push_back(moment);
    moment.scene = next;
    changes.push_back(moment);
    moment.dim = 1;
    changes.push_back(moment);
    // Each of them on every frame between a view's turns.
    for (std::size_t earlier = 0; earlier < 4; ++earlier) {
        std::vector<Moment> moments(earlier, changes.front());
        moments.insert(moments.end(), changes.begin(), changes.end());
        const auto held = shown(moments, {}, true);
        const auto whole = shown(moments, {}, false);
        for (std::size_t n = 0; n < moments.size(); ++n) EXPECT_LT(difference(held[n], whole[n]), kUnseen) << n;
        for (std::size_t n = earlier + 1; n < moments.size(); ++n)
            EXPECT_GT(difference(whole[n - 1], whole[n]), 2 * kUnseen) << n;
    }
}

// Four skies at once, of a new generation, cost a frame more than it has.
TEST(HeldSky, OfAnotherSceneWaitsForItsTurnWhereViewsAreSmall) {
    const SceneOf scene = nursery::grow(genome::random_recipe(base::Seed{3}), {65, 64, 128});
    const SceneOf next = nursery::grow(genome::random_recipe(base::Seed{4}), {65, 64, 128});
    std::vector<Moment> moments;
    for (int n = 0; n < 12; ++n) {
        const SceneOf& now = n < 5 ? scene : next;
        const float seconds = static_cast<float>(n) / 15;
        moments.push_back({now, looking_up(*now, seconds), seconds, 0, 0.5F});
    }
    const auto held = shown(moments, {}, true);
    const auto whole = shown(moments, {}, false);
    for (std::size_t n = 0; n < moments.size(); ++n) EXPECT_LT(difference(held[n], whole[n]), 2 * kUnseen) << n;
    EXPECT_EQ(difference(held[5], whole[5]), 0) << "drawn where it is seen";
    EXPECT_LE(held[5].triangles, whole[5].triangles);
    EXPECT_LT(held[9].triangles, whole[9].triangles) << "held again";
}

TEST(HeldSky, HasFewerStarsTheFaintestFirstWhereLittleIsDrawn) {
    const SceneOf day = nursery::grow(genome::random_recipe(base::Seed{5}), {65, 64, 128});
    auto sky = std::make_shared<scene::Sky>(*day->sky);
    sky->precipitation.kind = scene::Precipitation::Kind::None;
    for (int i = 0; i < 1000; ++i) {
        const float turn = 2.4F * static_cast<float>(i);
        const float up = 0.1F + 0.0008F * static_cast<float>(i);
        const float level = std::sqrt(1 - up * up);
        sky->stars.push_back(
            {{level * std::cos(turn), up, level * std::sin(turn)}, 1 - 0.001F * static_cast<float>(i)});
    }
    auto starry = std::make_shared<scene::Scene>(*day);
    starry->sky = sky;
    const auto with = [&](float alpha) {
        return shown({{starry, looking_up(*starry, 0), 0, 0, 1, alpha}}, {}, false).front();
    };
    EXPECT_EQ(with(0.5F).triangles, with(1).triangles);
    EXPECT_EQ(with(1).triangles - with(0.15F).triangles, 2 * 500U);
    EXPECT_EQ(with(1).triangles - with(0.01F).triangles, 2 * 850U);
    EXPECT_LT(difference(with(0.01F), with(1)), kUnseen);
}

}  // namespace
}  // namespace quadrat::stage
