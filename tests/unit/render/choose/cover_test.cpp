// SPDX-License-Identifier: Apache-2.0
#include "render/choose/cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "render/choose/allowance.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

// Cells of a hundred tufts along the way before the eye.
CoverOfScene meadow() {
    CoverOfScene cover;
    cover.reach_m = 60;
    for (int i = 0; i < 14; ++i) {
        scene::Sward::Cell cell;
        cell.first = cover.tufts.size();
        const float near_m = 4.0F * static_cast<float>(i);
        cell.low_m = {-2, 0, -near_m - 4};
        cell.high_m = {2, 0.5F, -near_m};
        cell.counts = {70, 20, 5, 5};
        for (int tuft = 0; tuft < 100; ++tuft)
            cover.tufts.push_back(
                {{0, 0, -near_m - 0.04F * static_cast<float>(tuft)}, {0.4F, 0}, 0.3F, {200, 200, 200, 200}});
        cover.cells.push_back(cell);
    }
    return cover;
}

Frustum northward() {
    const scene::Camera camera{{0, 2, 2}, {0, 1.5F, -10}, 42};
    return Frustum(scene::clip_from_view(camera, 16.0F / 9) * scene::view_from_world(camera));
}

ViewBlock seen_from(glm::vec3 eye_m) {
    ViewBlock view{};
    view.eye_seconds = {eye_m, 0};
    view.sunlight.w = 1;
    view.haze_colour = {0.8F, 0.8F, 0.8F, 1.0F / 60};
    view.haze_sunward = {0.8F, 0.8F, 0.8F, 0};
    view.mist = {0, 0, 1, 0};
    return view;
}

CoverSeen seen_at(float alpha, glm::vec3 eye_m = {0, 2, 2}) {
    const ViewBlock view = seen_from(eye_m);
    const Allowance allowance = allowance_of({alpha}, 1);
    return look_at_cover(meadow(), northward(), {&view, nullptr, 700, allowance.cover_whole, allowance.cover_reach, 1});
}

TEST(Cover, PalesIntoTheAirWithDistance) {
    const CoverSeen seen = seen_at(1);
    ASSERT_FALSE(seen.instances.empty());
    for (const CoverInstance& a : seen.instances)
        for (const CoverInstance& b : seen.instances) {
            if (a.root_m.z <= b.root_m.z) continue;  // b is farther
            ASSERT_LE(a.veil_gust[0], b.veil_gust[0]);
            ASSERT_GE(a.ground_lit[0], b.ground_lit[0]);
        }
}

TEST(Cover, NamesEachInstanceOfEachBatchOnce) {
    const CoverSeen seen = seen_at(1);
    ASSERT_FALSE(seen.batches.empty());
    std::size_t next = 0;
    std::size_t parts = 0;
    for (const CoverSeen::Batch& batch : seen.batches) {
        EXPECT_EQ(batch.first, next);
        EXPECT_GT(batch.parts, 0U);
        next += batch.count;
        parts += batch.count * batch.parts;
    }
    EXPECT_EQ(next, seen.instances.size());
    EXPECT_GE(seen.triangles, parts);
}

TEST(Cover, DrawsFewerBladesOfWhatIsFarther) {
    const CoverSeen seen = seen_at(1);
    const auto grass = [](const CoverSeen::Batch& batch) { return batch.kind == scene::CoverKind::Grass; };
    const auto first = std::ranges::find_if(seen.batches, grass);
    ASSERT_NE(first, seen.batches.end());
    for (const CoverSeen::Batch& batch : seen.batches) {
        if (!grass(batch)) continue;
        EXPECT_LE(batch.parts, first->parts);
    }
    EXPECT_LT(seen.triangles, seen.instances.size() * 20);
}

TEST(Cover, NeverTakesMoreTrianglesForLessDetail) {
    std::size_t before = 0;
    for (const float alpha : {0.01F, 0.05F, 0.1F, 0.3F, 0.6F, 1.0F, 2.0F}) {
        const std::size_t triangles = seen_at(alpha).triangles;
        EXPECT_GE(triangles, before) << alpha;
        before = triangles;
    }
}

TEST(Cover, EndsAtItsReachAndOutsideTheView) {
    EXPECT_TRUE(seen_at(1, {0, 2, 200}).instances.empty());
    const Frustum away(glm::perspective(0.7F, 1.8F, 0.5F, 1000.0F) *
                       glm::lookAt(glm::vec3{0, 2, 2}, glm::vec3{0, 2, 20}, glm::vec3{0, 1, 0}));
    const ViewBlock view = seen_from({0, 2, 2});
    EXPECT_TRUE(look_at_cover(meadow(), away, {&view, nullptr, 700, 1, 1}).instances.empty());
}

}  // namespace
}  // namespace quadrat::render::choose
