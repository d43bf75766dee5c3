// SPDX-License-Identifier: Apache-2.0
#include "render/choose/frustum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "base/seed.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

const glm::mat4 kClipFromWorld =
    scene::clip_from_view({}, 16.0F / 9) * scene::view_from_world({{10, 5, 20}, {-40, 2, -30}, 50});

bool is_on_screen(glm::vec3 at_m) {
    const glm::vec4 clip = kClipFromWorld * glm::vec4{at_m, 1};
    return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w;
}

glm::vec3 anywhere(base::RandomStream& stream, float reach_m) {
    return {stream.between(-reach_m, reach_m), stream.between(-reach_m, reach_m), stream.between(-reach_m, reach_m)};
}

TEST(Frustum, SeesAPointExactlyWhenItLandsOnTheScreen) {
    const Frustum frustum(kClipFromWorld);
    base::RandomStream stream{base::Seed{1}};
    int on_screen = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 at_m = anywhere(stream, 200);
        EXPECT_EQ(frustum.may_see_sphere(at_m, 0), is_on_screen(at_m));
        on_screen += is_on_screen(at_m);
    }
    EXPECT_GT(on_screen, 200);
}

TEST(Frustum, NeverHidesAConeOfWhichAPointIsOnTheScreen) {
    const Frustum frustum(kClipFromWorld);
    base::RandomStream stream{base::Seed{5}};
    int hidden = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 apex_m = i % 2 == 0 ? glm::vec3{10, 5, 20} : anywhere(stream, 60);
        const glm::vec3 middle = glm::normalize(anywhere(stream, 1));
        const std::array<glm::vec3, 3> ways{middle + anywhere(stream, 0.2F), middle + anywhere(stream, 0.2F),
                                            middle + anywhere(stream, 0.2F)};
        const bool may = frustum.may_see_cone(apex_m, ways);
        hidden += !may;
        const float a = stream.unit_f();
        const float b = (1 - a) * stream.unit_f();
        const glm::vec3 inside = a * ways[0] + b * ways[1] + (1 - a - b) * ways[2];
        for (const float far_m : {1.0F, 20.0F, 300.0F}) EXPECT_TRUE(may || !is_on_screen(apex_m + far_m * inside));
    }
    EXPECT_GT(hidden, 8'000);
}

TEST(Frustum, NeverHidesASphereOrABoxOfWhichAPointIsOnTheScreen) {
    const Frustum frustum(kClipFromWorld);
    base::RandomStream stream{base::Seed{2}};
    int hidden = 0;
    for (int i = 0; i < 4'000; ++i) {
        const glm::vec3 middle_m = anywhere(stream, 200);
        const float radius_m = stream.between(1, 30);
        bool is_seen = false;
        for (int k = 0; k < 40; ++k) {
            const glm::vec3 inside_m = middle_m + anywhere(stream, radius_m / 1.7321F);
            is_seen = is_seen || is_on_screen(inside_m);
        }
        const glm::vec3 half{radius_m / 1.7321F};
        if (is_seen) {
            EXPECT_TRUE(frustum.may_see_sphere(middle_m, radius_m));
            EXPECT_TRUE(frustum.may_see_box(middle_m - half, middle_m + half));
        }
        hidden += !frustum.may_see_box(middle_m - half, middle_m + half);
    }
    EXPECT_GT(hidden, 2'000);
}

}  // namespace
}  // namespace quadrat::render::choose
