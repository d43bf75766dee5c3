// SPDX-License-Identifier: Apache-2.0
#include "pictures/mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace quadrat::pictures {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// Metres from 200 to 1700, as an elevation model has them.
GreyPicture hills(std::optional<float> white = {}) {
    GreyPicture picture{mesh::Field(9, 9), white};
    for (std::size_t i = 0; i < 81; ++i) picture.samples.samples[i] = 200 + 1500 * static_cast<float>(i) / 80;
    return picture;
}

TEST(Mask, InMetresIsRefusedWithTheRangeToWrite) {
    EXPECT_THAT([] { mask_from(hills(), "dem.tif", {}, {}); },
                ThrowsMessage<base::InputError>(HasSubstr("dem.tif: its heights are from 200 to 1700")));
    EXPECT_THAT([] { mask_from(hills(), "dem.tif", {}, {}); },
                ThrowsMessage<base::InputError>(HasSubstr("--mask-range 200:1700")));
}

TEST(Mask, IsScaledByItsRange) {
    const Mask mask = mask_from(hills(), "dem.tif", MaskRange{200, 1700}, {});
    EXPECT_FLOAT_EQ(mask.share.samples.front(), 0);
    EXPECT_FLOAT_EQ(mask.share.samples[40], 0.5F);
    EXPECT_FLOAT_EQ(mask.share.samples.back(), 1);
    EXPECT_EQ(mask.holes, 0U);
    EXPECT_EQ(mask.cut, 0U);
}

TEST(Mask, OfWholeNumbersMeansWhatItDoesInAPicture) {
    GreyPicture picture = hills(65535.0F);
    picture.samples.samples.front() = 0;
    picture.samples.samples.back() = 65535;
    const Mask mask = mask_from(picture, "a.png", {}, {});
    EXPECT_FLOAT_EQ(mask.share.samples.front(), 0);
    EXPECT_FLOAT_EQ(mask.share.samples.back(), 1);
}

TEST(Mask, HolesHaveWhatIsAroundThem) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float hole : {-9999.0F, -32768.0F, -3.4e38F, std::numeric_limits<float>::infinity(), nan}) {
        GreyPicture picture = hills();
        picture.samples.samples[40] = hole;
        const Mask mask = mask_from(picture, "dem.tif", MaskRange{200, 1700}, {});
        EXPECT_EQ(mask.holes, 1U) << hole;
        EXPECT_EQ(mask.cut, 0U) << hole;
        EXPECT_NEAR(mask.share.samples[40], 0.5F, 0.1F) << hole;
    }
}

TEST(Mask, AValueThatIsNamedIsAHoleAndAUsualOneWithinTheRangeIsNone) {
    GreyPicture picture = hills();
    picture.samples.samples[40] = 0;
    EXPECT_EQ(mask_from(picture, "dem.tif", MaskRange{200, 1700}, 0.0F).holes, 1U);
    picture.samples.samples[40] = -9999;
    EXPECT_EQ(mask_from(picture, "sea.tif", MaskRange{-11000, 9000}, {}).holes, 0U);
}

TEST(Mask, AValueThatTheFileItselfNamesIsAHole) {
    GreyPicture picture = hills();
    picture.samples.samples[40] = 600;
    picture.nodata = 600.0F;
    EXPECT_EQ(mask_from(picture, "dem.tif", MaskRange{200, 1700}, {}).holes, 1U);
    EXPECT_EQ(mask_from(picture, "dem.tif", MaskRange{200, 1700}, 1700.0F).holes, 1U) << "what is asked for counts";
    picture.white = 65535.0F;
    EXPECT_EQ(mask_from(picture, "dem.tif", MaskRange{200, 1700}, {}).holes, 1U) << "of whole numbers too";
}

TEST(Mask, BeyondItsRangeIsCutAndCounted) {
    const Mask mask = mask_from(hills(), "dem.tif", MaskRange{200, 950}, {});
    EXPECT_EQ(mask.cut, 40U);
    EXPECT_FLOAT_EQ(mask.share.samples.back(), 1);
}

TEST(Mask, OfHolesAloneIsRefused) {
    GreyPicture picture{mesh::Field(3, 3), {}};
    for (float& sample : picture.samples.samples) sample = -9999;
    EXPECT_THAT(
        [&] {
            mask_from(picture, "dem.tif", MaskRange{0, 1}, {});
        },
        ThrowsMessage<base::InputError>(HasSubstr("none of its 9 samples is a height")));
}

TEST(MaskRange, IsTwoNumbersTheLowerFirst) {
    EXPECT_FLOAT_EQ(mask_range_from("-10.5:1700").low, -10.5F);
    for (const char* wrong : {"", "3", "3:", "5:5", "9:1", "0:1x", "0:nan", "a:b"})
        EXPECT_THROW(mask_range_from(wrong), base::InputError) << wrong;
}

}  // namespace
}  // namespace quadrat::pictures
