// SPDX-License-Identifier: Apache-2.0
#include "render/choose/hold.hpp"

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "base/seed.hpp"

namespace quadrat::render::choose {
namespace {

glm::mat4 clip_from_world(const scene::Camera& camera) {
    return scene::clip_from_view(camera, 16.0F / 9) * scene::view_from_world(camera);
}

// Moved and turned by nearly as much as is allowed.
scene::Camera nudged(const scene::Camera& camera, base::RandomStream& random) {
    glm::vec3 way{random.normal(), random.normal(), random.normal()};
    const glm::vec3 moved_m = 0.98F * Hold::kMoved_m * glm::normalize(way);
    const glm::vec3 ahead = glm::normalize(camera.target_m - camera.eye_m);
    const glm::vec3 aside = glm::normalize(glm::cross(ahead, glm::vec3{random.normal(), 1, random.normal()}));
    scene::Camera later = camera;
    later.eye_m += moved_m;
    later.target_m = later.eye_m + 100.0F * glm::normalize(ahead + 0.95F * Hold::kTurned_rad * aside);
    return later;
}

TEST(Hold, ServesWhileTheEyeHasHardlyMovedAndNoLonger) {
    const scene::Camera camera{{3, 5, 7}, {30, 2, -90}, 42};
    Hold hold;
    EXPECT_FALSE(hold.serves(camera));
    hold.choose(camera);
    base::RandomStream random{base::Seed{2}};
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(hold.serves(nudged(camera, random)));
    scene::Camera moved = camera;
    moved.eye_m.x += 0.08F;
    moved.target_m.x += 0.08F;
    EXPECT_FALSE(hold.serves(moved));
    scene::Camera turned = camera;
    turned.target_m.y += 1;
    EXPECT_FALSE(hold.serves(turned));
    scene::Camera zoomed = camera;
    zoomed.vertical_fov_deg = 41;
    EXPECT_FALSE(hold.serves(zoomed));
    hold.drop();
    EXPECT_FALSE(hold.serves(camera));
}

TEST(Hold, TheWiderViewHoldsWhateverIsSeenWhileItServes) {
    base::RandomStream random{base::Seed{3}};
    int seen = 0;
    for (int i = 0; i < 300; ++i) {
        const scene::Camera camera{
            {0, 10, 0}, {100 * random.normal(), 10 + random.between(-12, 6), -100 * random.unit_f() - 1}, 42};
        const Frustum wider = Hold::wider(clip_from_world(camera));
        const scene::Camera later = nudged(camera, random);
        const Frustum now(clip_from_world(later));
        for (int k = 0; k < 300; ++k) {
            const glm::vec3 way = glm::normalize(glm::vec3{random.normal(), random.normal(), random.normal()});
            const glm::vec3 at_m = later.eye_m + way * random.between(4, 40);
            if (!now.may_see_sphere(at_m, 0)) continue;
            ++seen;
            EXPECT_TRUE(wider.may_see_sphere(at_m, 0));
        }
    }
    EXPECT_GT(seen, 2'000);
}

}  // namespace
}  // namespace quadrat::render::choose
