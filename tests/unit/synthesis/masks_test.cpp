// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/masks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/land/erosion.hpp"
#include "synthesis/land/field_methods.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

mesh::Field rough(int size) {
    land::FieldRequest r;
    r.size = size;
    r.seed = base::Seed{3};
    r.features = 6;
    r.gain = 0.6F;
    return land::make_field(*land::field_method("fbm"), r);
}

// A ridge across a plain, as somebody might have painted it, coarser than the field.
mesh::Field ridge() {
    mesh::Field mask(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) mask.at(x, y) = 2.0F * std::exp(-0.02F * static_cast<float>((x - y) * (x - y)));
    return mask;
}

double roughness(const mesh::Field& field) {
    double sum = 0;
    for (int y = 0; y < field.rows; ++y)
        for (int x = 1; x + 1 < field.columns; ++x)
            sum += std::abs(field.at(x - 1, y) - 2 * field.at(x, y) + field.at(x + 1, y));
    return sum;
}

TEST(Masks, AreMetInTheMeanWithinATwentiethOfTheirRange) {
    mesh::Field field = rough(257);
    EXPECT_LT(land::follow_mask(field, ridge(), 8), 0.05F * 2.0F);
}

TEST(Masks, LeaveTheFieldItsOwnRoughness) {
    mesh::Field field = rough(257);
    const double before = roughness(field);
    land::follow_mask(field, ridge(), 8);
    EXPECT_NEAR(roughness(field), before, 0.05 * before);
}

TEST(Masks, AreResampledCornerToCorner) {
    const mesh::Field mask = ridge();
    const mesh::Field larger = land::resampled(mask, 118, 79);
    EXPECT_FLOAT_EQ(larger.at(0, 0), mask.at(0, 0));
    EXPECT_NEAR(larger.at(117, 78), mask.at(39, 39), 1e-5);
    EXPECT_NEAR(larger.at(117, 0), mask.at(39, 0), 1e-5);
    EXPECT_NEAR(larger.at(39, 26), mask.at(13, 13), 1e-3);
}

TEST(Masks, HolesOfAPlaneAreFilledWithThePlane) {
    mesh::Field plane(33, 33);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) plane.at(x, y) = 0.1F * static_cast<float>(x) - 0.05F * static_cast<float>(y);
    mesh::Field holed = plane;
    for (int y = 10; y < 14; ++y)
        for (int x = 20; x < 24; ++x) holed.at(x, y) = std::nanf("");
    land::fill_holes(holed);
    for (std::size_t i = 0; i < plane.samples.size(); ++i) EXPECT_NEAR(holed.samples[i], plane.samples[i], 0.15F) << i;
    mesh::Field nothing(3, 2);
    for (float& sample : nothing.samples) sample = std::nanf("");
    land::fill_holes(nothing);
    EXPECT_TRUE(std::isnan(nothing.samples.front())) << "nothing is known anywhere";
}

}  // namespace
