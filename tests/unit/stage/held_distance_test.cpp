// SPDX-License-Identifier: Apache-2.0
// What is far of frames that follow each other is a picture of some frames ago: it looks as if it were drawn anew,
// where it serves, and does not serve where it would not.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <glm/gtc/matrix_transform.hpp>

#include "base/seed.hpp"
#include "pictures/flight.hpp"
#include "render/held_distance.hpp"
#include "render/view.hpp"

namespace quadrat::stage {
namespace {

using SceneOf = std::shared_ptr<const scene::Scene>;
using tests::Flight;

constexpr glm::ivec2 kSize{640, 360};
constexpr float kHz = 60;
constexpr std::size_t kFrames = render::HeldDistances::kFrames;

std::vector<SceneOf> four(std::uint64_t seed) {
    std::vector<SceneOf> scenes;
    for (std::uint64_t i = 0; i < 4; ++i)
        scenes.push_back(nursery::grow(genome::random_recipe(base::Seed{seed + i}), {129, 128, 256}));
    return scenes;
}

// Leaves are smaller than a pixel, and each drawing of them differs. What is held may differ from what is drawn anew by
// as much as the flight itself changes the picture in so many frames.
constexpr int kUnseenFrames = 3;

// A flight at its fastest, that has been seen for so many frames.
constexpr float kFastest_s = 20;
float seconds_of(int frame) { return kFastest_s + static_cast<float>(frame) / kHz; }
void warm_up(Flight& flight, int frames = 3 * kFrames) {
    for (int n = -frames; n < 0; ++n) flight.draw(seconds_of(n));
}

double changed_by(Flight& anew) {
    const mesh::Image later = anew.draw(seconds_of(kUnseenFrames)).pixels;
    return tests::off(anew.draw(seconds_of(0)).pixels, later).rms;
}

// Over a flight of four landscapes.
struct Difference {
    double off2 = 0;    // of what is held from what is drawn anew, mean square
    double moved2 = 0;  // of what is drawn anew from the same some frames ago
    double worst = 0;   // the same two of a tile, the most
    double worst_moved = 0;
    double held_triangles = 0;
    double all_triangles = 0;
};

Difference along_a_flight(std::uint64_t seed, int frames) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(seed);
    Flight held(easel, scenes, kSize, true);
    Flight anew(easel, scenes, kSize, false);
    warm_up(held);
    warm_up(anew);
    Difference all;
    mesh::Image held_before;
    std::deque<mesh::Image> anew_before;
    for (int n = 0; n < frames; ++n) {
        const Flight::Shown a = held.draw(seconds_of(n));
        const Flight::Shown b = anew.draw(seconds_of(n));
        const tests::Off off = tests::off(a.pixels, b.pixels);
        EXPECT_EQ(a.drawn.held_views, 4U) << n;
        EXPECT_EQ(b.drawn.held_views, 0U) << n;
        // A redraw would be seen as a frame that differs from the one before it by more than the flight makes it.
        if (n > 0) {
            EXPECT_LT(tests::off(a.pixels, held_before).rms, 1.05 * tests::off(b.pixels, anew_before.back()).rms) << n;
        }
        held_before = a.pixels;
        anew_before.push_back(b.pixels);
        if (anew_before.size() > kUnseenFrames) {
            const tests::Off by_flight = tests::off(anew_before.front(), b.pixels);
            all.moved2 += std::pow(by_flight.rms, 2) / (frames - kUnseenFrames);
            all.worst_moved = std::max(all.worst_moved, by_flight.worst);
            anew_before.pop_front();
        }
        all.off2 += off.rms * off.rms / frames;
        all.worst = std::max(all.worst, off.worst);
        all.held_triangles += static_cast<double>(a.drawn.triangles) / frames;
        all.all_triangles += static_cast<double>(b.drawn.triangles) / frames;
    }
    return all;
}

TEST(HeldDistance, LooksAsIfItWereDrawnAnewAllAlongAFlight) {
    Difference sum;
    for (const std::uint64_t seed : {1U, 5U, 9U}) {  // twelve landscapes
        const Difference one = along_a_flight(seed, 60);
        std::printf("rms %.2f of %.2f, worst tile %.2f of %.2f, triangles %.0f of %.0f\n", std::sqrt(one.off2),
                    std::sqrt(one.moved2), one.worst, one.worst_moved, one.held_triangles, one.all_triangles);
        sum.off2 += one.off2;
        sum.moved2 += one.moved2;
        sum.worst += one.worst;
        sum.worst_moved += one.worst_moved;
        EXPECT_LT(one.held_triangles, 0.8 * one.all_triangles) << seed;
    }
    EXPECT_LT(sum.off2, sum.moved2);
    // Strokes that are no pixel wide are softer where they are held than drawn anew.
    EXPECT_LT(sum.worst, 0.92 * sum.worst_moved);
}

TEST(HeldDistance, IsDrawnOneViewInAFrameAndWithoutGrowth) {
    Easel easel(kSize.x, kSize.y);
    Flight flight(easel, four(3), kSize, true);
    warm_up(flight);
    const std::size_t objects = flight.draw(seconds_of(0)).drawn.objects;
    for (int n = 1; n < 40; ++n) {
        const render::Drawn drawn = flight.draw(seconds_of(n)).drawn;
        EXPECT_EQ(drawn.held_anew, 1U) << n;
        EXPECT_EQ(drawn.objects, objects) << n;
    }
}

// Not even the first frames of a generation, which hold nothing yet, are dearer than frames that are drawn whole.
TEST(HeldDistance, IsShownAtOnceWhereNothingServes) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(1);
    Flight held(easel, scenes, kSize, true);
    Flight anew(easel, scenes, kSize, false);
    const double allowed = changed_by(anew);
    std::size_t before = 0;
    for (int n = 0; n < 12; ++n) {
        const Flight::Shown a = held.draw(seconds_of(n));
        const Flight::Shown b = anew.draw(seconds_of(n));
        EXPECT_LT(static_cast<double>(a.drawn.triangles), 1.12 * static_cast<double>(b.drawn.triangles)) << n;
        EXPECT_LT(tests::off(a.pixels, b.pixels).rms, allowed) << n;
        EXPECT_GE(a.drawn.held_views, before) << n;
        before = a.drawn.held_views;
    }
    EXPECT_EQ(before, 4U);
}

TEST(HeldDistance, OfOneViewIsDrawnAStripInAFrame) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> one{four(5).front()};
    Flight flight(easel, one, kSize, true);
    Flight anew(easel, one, kSize, false);
    warm_up(flight);
    warm_up(anew);
    const double allowed = changed_by(anew);
    for (int n = 0; n < 20; ++n) {
        const Flight::Shown a = flight.draw(seconds_of(n));
        const Flight::Shown b = anew.draw(seconds_of(n));
        EXPECT_EQ(a.drawn.held_anew, 1U) << n;
        EXPECT_EQ(a.drawn.held_views, 1U) << n;
        EXPECT_LT(tests::off(a.pixels, b.pixels).rms, allowed) << n;
        EXPECT_LT(a.drawn.triangles, b.drawn.triangles) << n;
    }
}

TEST(HeldDistance, ServesSmoothFramesSmallOnesAndPanelsThatHangAsTheyMust) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(1);
    struct Case {
        render::Detail detail;
        render::Hanging hanging;
    };
    for (const Case& how : {Case{{1, 1, 4}, {}}, Case{{1, 0.75F, 1}, {}}, Case{{1, 1, 1}, {1, true}}}) {
        const glm::ivec2 size = render::turned_size(kSize, how.hanging);
        Flight held(easel, scenes, size, true);
        Flight anew(easel, scenes, size, false);
        for (Flight* flight : {&held, &anew}) {
            flight->frame.detail = how.detail;
            flight->frame.hanging = how.hanging;
            warm_up(*flight);
        }
        const Flight::Shown a = held.draw(seconds_of(0));
        const Flight::Shown b = anew.draw(seconds_of(0));
        EXPECT_EQ(a.drawn.held_views, 4U);
        EXPECT_LT(tests::off(a.pixels, b.pixels).rms, changed_by(anew))
            << how.detail.samples << ' ' << how.detail.scale << ' ' << how.hanging.quarter_turns;
    }
}

TEST(HeldDistance, LeavesSinglePicturesAsTheyAre) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(3);
    Flight flight(easel, scenes, kSize, true);
    warm_up(flight);
    flight.frame.is_one_of_many = false;
    const Flight::Shown after = flight.draw(seconds_of(0));
    Flight fresh(easel, scenes, kSize, true);
    fresh.frame.is_one_of_many = false;
    EXPECT_EQ(after.drawn.held_views, 0U);
    EXPECT_EQ(after.pixels.bytes, fresh.draw(seconds_of(0)).pixels.bytes);
}

TEST(HeldDistance, IsTheSameEachTime) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(3);
    Flight one(easel, scenes, kSize, true);
    Flight other(easel, scenes, kSize, true);
    warm_up(one);
    warm_up(other);
    for (int n = 0; n < 6; ++n) EXPECT_EQ(one.draw(seconds_of(n)).pixels.bytes, other.draw(seconds_of(n)).pixels.bytes);
}

// Each time the frame is as one that holds nothing.
TEST(HeldDistance, DoesNotServeAfterACutNorWhileALandscapeGrowsNorWhereTimeJumps) {
    Easel easel(kSize.x, kSize.y);
    const std::vector<SceneOf> scenes = four(3);
    Flight flight(easel, scenes, kSize, true);
    // The view in whose turn it is may be drawn for this frame already.
    const auto expect_held = [&](std::size_t views, const char* when) {
        const render::Drawn drawn = flight.draw().drawn;
        EXPECT_GE(drawn.held_views, views) << when;
        EXPECT_LE(drawn.held_views, views + drawn.held_anew) << when;
    };
    warm_up(flight);
    flight.frame.views[0].camera.eye_m += glm::vec3{8, 0, 0};
    flight.frame.views[0].camera.target_m += glm::vec3{8, 0, 0};
    expect_held(3, "moved far");
    warm_up(flight);
    flight.frame.views[1].camera.target_m =
        flight.frame.views[1].camera.eye_m -
        (flight.frame.views[1].camera.target_m - flight.frame.views[1].camera.eye_m);
    expect_held(3, "turned about");
    warm_up(flight);
    flight.frame.views[2].growth = 0.5F;
    expect_held(3, "growing");
    flight.frame.views[2].growth = 1;
    warm_up(flight);
    std::swap(flight.frame.views[0].scene, flight.frame.views[3].scene);
    expect_held(2, "other scenes");
    warm_up(flight);
    flight.frame.views[1].dim = 1;
    expect_held(3, "dimmed at once");
    flight.frame.views[1].dim = 0;
    warm_up(flight);
    flight.frame.seconds += 60;
    expect_held(0, "time jumped");
    warm_up(flight);
    flight.frame.views[3].viewport.width -= 40;
    expect_held(3, "another shape");
    flight.frame.views[3].viewport.width += 40;
    warm_up(flight);
    expect_held(4, "at rest");
    flight.frame.measured.is_counted = true;
    expect_held(0, "counted");
    flight.frame.measured = {};
    flight.frame.measured.ground = false;
    expect_held(0, "a part");
    flight.frame.measured = {};
    expect_held(4, "after that");
}

// A flight so slow in frames, or so fast, that nothing near could be held leaves all to be drawn.
TEST(HeldDistance, BeginsFartherTheFasterTheFlight) {
    using render::HeldDistance;
    EXPECT_FLOAT_EQ(HeldDistance::off_px(0.2F, HeldDistance::split_m(0.2F, 703), 703), HeldDistance::kMost_px);
    Easel easel(kSize.x, kSize.y);
    Flight flight(easel, four(3), kSize, true);
    float before_m = 0;
    for (const float hz : {60.0F, 15.0F, 8.0F}) {
        render::Drawn drawn;
        for (int n = 0; n < 16; ++n) drawn = flight.draw(kFastest_s + static_cast<float>(n) / hz).drawn;
        EXPECT_GE(drawn.held_from_m, before_m) << hz;
        before_m = drawn.held_from_m;
    }
    for (int n = 0; n < 16; ++n)
        EXPECT_EQ(n < 8 ? 0 : flight.draw(static_cast<float>(10 * n)).drawn.held_views, 0U) << "ten seconds a frame";
}

// Points beyond the split, seen from an eye that has moved as far as is allowed: they lie no farther from where the
// held picture shows them than is said, times the secant squared that a picture plane stretches its rim by.
TEST(HeldDistance, ShowsWhatLiesBeyondTheSplitWithinItsBound) {
    base::RandomStream random{base::Seed{7}};
    render::View view;
    view.viewport = {0, 0, 960, 540};
    view.camera = {{0, 2, 0}, {0, 1, -10}, 42};
    const float px = render::pixels_per_radian(view);
    double most = 0;
    for (int turn = 0; turn < 200; ++turn) {
        render::HeldDistance::Sight sight;
        sight.split_m = random.between(40, 200);
        sight.eye_m = view.camera.eye_m;
        const glm::mat3 half{{0.5F, 0, 0}, {0, 0.5F, 0}, {0.5F, 0.5F, 1}};
        sight.picture_from_way = half * render::clip_from_direction(render::clip_from_world_of(view));
        const float moved_m = 2 * sight.split_m * render::HeldDistance::kMost_px / px;
        render::View later = view;
        const glm::vec3 way =
            glm::normalize(glm::vec3{random.between(-1, 1), random.between(-0.3F, 0.3F), random.between(-1, 1)});
        later.camera.eye_m += moved_m * way;
        later.camera.target_m += moved_m * way + glm::vec3{random.between(-0.1F, 0.1F), 0, 0};
        const glm::mat4 clip_from_world = render::clip_from_world_of(later);
        const auto warp = render::HeldDistance::warp(sight, clip_from_world, later.camera.eye_m);
        for (int i = 0; i < 200; ++i) {
            const float away_m = sight.split_m / random.between(0.001F, 1);
            const float bearing = random.between(-0.55F, 0.55F);
            const glm::vec3 at_m =
                sight.eye_m + glm::vec3{away_m * std::sin(bearing), away_m * random.between(-0.2F, 0.3F),
                                        -away_m * std::cos(bearing)};
            const glm::vec4 clip = clip_from_world * glm::vec4{at_m, 1};
            const glm::vec2 seen = glm::vec2{clip} / clip.w;
            if (std::max(std::abs(seen.x), std::abs(seen.y)) > 1) continue;
            const glm::vec3 held = sight.picture_from_way * (at_m - sight.eye_m);
            const glm::vec3 shown = render::HeldDistance::over_held(warp, seen);
            const glm::vec2 off = (glm::vec2{held} / held.z - glm::vec2{shown} / shown.z) *
                                  glm::vec2{view.viewport.width, view.viewport.height};
            const glm::vec2 tangent = seen * glm::vec2{16.0F / 9, 1} * std::tan(glm::radians(21.0F));
            EXPECT_LE(glm::length(off),
                      1.02F * render::HeldDistance::kMost_px * (1 + glm::dot(tangent, tangent)) + 0.01F);
            most = std::max(most, static_cast<double>(glm::length(off)));
        }
    }
    EXPECT_GT(most, 0.5 * render::HeldDistance::kMost_px) << "the bound is not idle";
}

}  // namespace
}  // namespace quadrat::stage
