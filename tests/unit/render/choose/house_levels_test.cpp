// SPDX-License-Identifier: Apache-2.0
#include "render/choose/house_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

// So many triangles, each with corners of its own.
scene::Masses triangles(std::size_t count) {
    scene::Masses masses;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
        masses.mesh.indices.push_back(i);
        masses.mesh.positions_m.emplace_back(static_cast<float>(i % 3), static_cast<float>(i % 2), 0.0F);
        masses.mesh.normals.emplace_back(0, 0, 1);
        masses.mesh.texcoords.emplace_back(0, 0);
        masses.colours.emplace_back(0.5F);
        masses.claddings.push_back(scene::Cladding::Plaster);
        masses.lamps.push_back(0);
    }
    return masses;
}

constexpr std::size_t kFinest = 40, kMiddle = 10, kCoarsest = 2;

// Houses in a row away from the eye.
scene::Settlement row(std::size_t count, float step_m) {
    scene::Settlement settlement;
    settlement.buildings.push_back({{triangles(kFinest), triangles(kMiddle), triangles(kCoarsest)}, {4, 4}, 6, {}});
    for (std::size_t i = 0; i < count; ++i) {
        scene::House house;
        house.foot_m = {0, -3, -30 - step_m * static_cast<float>(i)};
        settlement.houses.push_back(house);
    }
    return settlement;
}

Frustum ahead() {
    const scene::Camera camera{{0, 0, 0}, {0, 0, -100}, 42};
    return Frustum(scene::clip_from_view(camera, 1.5F) * scene::view_from_world(camera));
}

std::vector<std::uint32_t> selected(const HouseLevels& levels, const HouseLevels::Wish& wish) {
    std::vector<std::uint32_t> indices;
    levels.select(ahead(), wish, indices);
    return indices;
}

TEST(Houses, AreCoarserTheFartherTheyStand) {
    const auto corners_at = [](float away_m) {
        scene::Settlement one = row(1, 0);
        one.houses[0].foot_m.z = -away_m;
        return selected(HouseLevels(one), {{0, 0, 0}, 700, 1, 1, nullptr, {}}).size();
    };
    EXPECT_EQ(corners_at(40), 3 * kFinest);
    EXPECT_EQ(corners_at(250), 3 * kMiddle);
    EXPECT_EQ(corners_at(900), 3 * kCoarsest);
    EXPECT_EQ(corners_at(11'000), 0U) << "less than a pixel";
}

TEST(Houses, BehindTheEyeAreLeftOut) {
    scene::Settlement one = row(1, 0);
    one.houses[0].foot_m.z = 50;
    EXPECT_TRUE(selected(HouseLevels(one), {{0, 0, 0}, 700, 1, 1, nullptr, {}}).empty());
}

TEST(Houses, AreBuiltInTheirOrderAsALandscapeGrows) {
    const HouseLevels levels(row(8, 12));
    std::size_t before = 0;
    for (const float standing : {0.0F, 0.25F, 0.5F, 1.0F}) {
        const auto indices = selected(levels, {{0, 0, 0}, 700, 1, standing, nullptr, {}});
        EXPECT_GE(indices.size(), before);
        before = indices.size();
        if (standing == 0.25F) {
            EXPECT_EQ(indices.size(), 2 * 3 * kFinest);
        }
    }
}

TEST(Houses, InAllViewsOfASplitEachIsDrawn) {
    const HouseLevels levels(row(8, 25));
    const HouseLevels::Wish whole{{0, 0, 0}, 700, 1, 1, nullptr, {}};
    HouseLevels::Wish near = whole;
    near.reach = {Reach::Part::Near, {0, 0}, 100};
    HouseLevels::Wish far = whole;
    far.reach = {Reach::Part::Far, {0, 0}, 100};
    EXPECT_GE(selected(levels, near).size() + selected(levels, far).size(), selected(levels, whole).size());
    EXPECT_LT(selected(levels, near).size(), selected(levels, whole).size());
}

// Of a town only the houses that a viewer comes near have their finest level; others are drawn by their next one.
TEST(Houses, OfATownOnlyTheNearestHaveTheirFinestLevel) {
    const HouseLevels levels(row(120, 0.5F));
    const auto indices = selected(levels, {{0, 0, 0}, 7000, 1, 1, nullptr, {}});
    EXPECT_EQ(indices.size(), 3 * (90 * kFinest + 30 * kMiddle));
}

}  // namespace
}  // namespace quadrat::render::choose
