// SPDX-License-Identifier: Apache-2.0
#include "mesh/field.hpp"

#include <gtest/gtest.h>

namespace {

using quadrat::mesh::Field;
using quadrat::mesh::sample;

Field ramp() {
    Field field(4, 3);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            field.at(column, row) = 2.0F * static_cast<float>(column) - static_cast<float>(row);
    return field;
}

TEST(FieldSample, GivesTheSamplesThemselvesAtTheirPlaces) {
    const Field field = ramp();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_EQ(sample(field, static_cast<float>(column), static_cast<float>(row)), field.at(column, row));
}

TEST(FieldSample, FollowsAPlaneExactlyBetweenTheSamples) {
    EXPECT_FLOAT_EQ(sample(ramp(), 1.25F, 0.5F), 2.0F);
    EXPECT_FLOAT_EQ(sample(ramp(), 2.75F, 1.75F), 3.75F);
}

TEST(FieldSample, TakesTheNearestEdgeOutside) {
    EXPECT_FLOAT_EQ(sample(ramp(), -5, 1), -1);
    EXPECT_FLOAT_EQ(sample(ramp(), 9, 9), 4);
}

TEST(FieldSample, OfNothingIsZero) { EXPECT_EQ(sample(Field{}, 3, 4), 0); }

}  // namespace
