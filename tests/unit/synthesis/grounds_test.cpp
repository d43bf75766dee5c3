// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/grounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace quadrat::synthesis::houses {
namespace {

constexpr int kSide_px = 64;

// A brown field on level ground, whose picture is of one grey before it is painted.
int red_in_field(std::uint8_t ground, float snow_line_m) {
    scene::Land land;
    land.height_m = mesh::Field(9, 9, 10.0F);
    land.cell_m = 8;
    land.snow_line_m = snow_line_m;
    mesh::Image albedo(kSide_px, kSide_px, 4);
    albedo.bytes.assign(albedo.bytes.size(), ground);
    scene::FieldPlot field;
    field.outline_m = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    field.along = {1, 0};
    field.colour = {0.49F, 0.40F, 0.29F};
    paint_grounds(albedo, land, {}, {field}, 0, base::Seed{1});
    return albedo.pixel(kSide_px / 2, kSide_px / 2)[0];
}

TEST(Fields, LieUnderSnowWhereItWasPainted) {
    constexpr std::uint8_t kSnow = 230;
    constexpr std::uint8_t kEarth = 90;
    EXPECT_GT(red_in_field(kSnow, 9), 210) << "however close to the line";
    EXPECT_LT(red_in_field(kEarth, 9), 140) << "where the wind has left it bare";
    EXPECT_LT(red_in_field(kSnow, 11), 160) << "below it, it is sand";
}

}  // namespace
}  // namespace quadrat::synthesis::houses
