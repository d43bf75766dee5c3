// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/crops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/land.hpp"
#include "synthesis/compose/sward.hpp"
#include "unit/synthesis/plain_colour.hpp"

namespace quadrat::synthesis {
namespace {

// 40 m wide about a place, its rows at a slant.
scene::FieldPlot square(glm::vec2 middle_m, scene::Crop crop) {
    scene::FieldPlot field;
    for (const glm::vec2 corner : {glm::vec2{-20, -20}, {20, -20}, {20, 20}, {-20, 20}})
        field.outline_m.push_back(middle_m + corner);
    field.along = glm::normalize(glm::vec2{2, 1});
    field.crop = crop;
    return field;
}

TEST(Crops, AreFoundOnTheirFieldAndNotAtItsEdge) {
    const std::vector<scene::FieldPlot> fields{square({0, 0}, scene::Crop::RipeCorn),
                                               square({60, 0}, scene::Crop::Roots)};
    const Crops crops(fields);
    EXPECT_EQ(crops.at({3, -4}), &fields[0]);
    EXPECT_EQ(crops.at({60, 15}), &fields[1]);
    EXPECT_EQ(crops.at({19.5F, 0}), nullptr);
    EXPECT_EQ(crops.at({30, 0}), nullptr);
    EXPECT_EQ(Crops({}).at({0, 0}), nullptr);
}

TEST(Crops, AreMovedIntoTheNearestRowAndAcrossItAlone) {
    const scene::FieldPlot field = square({0, 0}, scene::Crop::Roots);
    const glm::vec2 across{-field.along.y, field.along.x};
    constexpr float kRows_m = 0.75F;
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 at{0.17F * static_cast<float>(i) - 17, 11 - 0.13F * static_cast<float>(i)};
        const glm::vec2 moved = in_row(field, kRows_m, at);
        const float row = glm::dot(moved, across) / kRows_m;
        EXPECT_NEAR(row, std::round(row), 1e-3F);
        EXPECT_NEAR(glm::dot(moved - at, field.along), 0, 1e-4F);
        EXPECT_LE(glm::distance(moved, at), 0.5F * kRows_m + 1e-4F);
        EXPECT_EQ(in_row(field, 0, at), at);
    }
}

// Level ground, all of it earth that is kept clear, with one field before a short flight.
scene::Sward on_field(scene::Crop crop) {
    scene::Land land;
    land.cell_m = 2;
    land.height_m = mesh::Field(129, 129, 4.0F);
    land.albedo = tests::plain_colour(tests::kEarth);
    land.kept_clear = scene::kept_clear_of(mesh::Field(129, 129));
    land.settlement.fields.push_back(square({0, 20}, crop));
    const FlightPlan flight{{{{0, 60}, {0, -1}}, {{2, 50}, {0, -1}}}};
    return lay_sward(land, {}, flight, base::Seed{5});
}

TEST(Sward, OfAFieldIsItsCrop) {
    for (const scene::Tuft& clod : on_field(scene::Crop::Ploughed).tufts) {
        EXPECT_EQ(clod.kind, scene::CoverKind::Stone);
        EXPECT_LT(clod.height_m, 0.15F);
    }
    const scene::Sward corn = on_field(scene::Crop::RipeCorn);
    const scene::Sward stubble = on_field(scene::Crop::Stubble);
    ASSERT_GT(corn.tufts.size(), 1000U);
    ASSERT_GT(stubble.tufts.size(), 1000U);
    for (const scene::Tuft& tuft : corn.tufts) {
        EXPECT_LT(std::max(std::abs(tuft.root_m.x), std::abs(tuft.root_m.z - 20)), 20);
        EXPECT_GT(tuft.height_m, 0.6F);
        EXPECT_GT(tuft.tint.r, tuft.tint.b);
    }
    for (const scene::Tuft& tuft : stubble.tufts) EXPECT_LT(tuft.height_m, 0.25F);
    for (const scene::Tuft& tuft : on_field(scene::Crop::Roots).tufts) EXPECT_EQ(tuft.kind, scene::CoverKind::Cushion);
}

}  // namespace
}  // namespace quadrat::synthesis
