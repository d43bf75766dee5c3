// SPDX-License-Identifier: Apache-2.0
#include "render/pictogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quadrat::render {
namespace {

std::vector<float> ink_of(Pictogram which, int size) {
    const mesh::Image image = pictogram(which, size);
    std::vector<float> ink;
    for (std::size_t i = 0; i < image.bytes.size(); i += 4) ink.push_back(static_cast<float>(image.bytes[i]) / 255);
    return ink;
}

// Also at the size of a small letter, half of which differs from any other.
TEST(Pictograms, AreToldApartByTheirSilhouettes) {
    for (const int size : {24, 64})
        for (int a = 0; a < kPictograms; ++a) {
            const std::vector<float> one = ink_of(static_cast<Pictogram>(a), size);
            float own = 0;
            for (const float ink : one) own += ink;
            EXPECT_GT(own, 0.06F * static_cast<float>(one.size())) << a;
            EXPECT_LT(own, 0.6F * static_cast<float>(one.size())) << a;
            for (int b = 0; b < a; ++b) {
                const std::vector<float> other = ink_of(static_cast<Pictogram>(b), size);
                float differs = 0;
                for (std::size_t i = 0; i < one.size(); ++i) differs += std::abs(one[i] - other[i]);
                EXPECT_GT(differs, 0.35F * own) << a << " " << b;
            }
        }
}

TEST(Pictograms, LeaveTheirRimClear) {
    for (int which = 0; which < kPictograms; ++which) {
        const mesh::Image image = pictogram(static_cast<Pictogram>(which), 48);
        ASSERT_EQ(image.width, 48);
        ASSERT_EQ(image.height, 48);
        for (int i = 0; i < 48; ++i)
            for (const auto* pixel : {image.pixel(i, 0), image.pixel(i, 47), image.pixel(0, i), image.pixel(47, i)})
                EXPECT_EQ(pixel[0], 0) << which;
    }
}

}  // namespace
}  // namespace quadrat::render
