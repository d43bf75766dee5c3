// SPDX-License-Identifier: Apache-2.0
#include "display/kms/edid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/seed.hpp"
#include "unit/display/edid_maker.hpp"

namespace quadrat::display {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MadeEdid;
using testing::MadeTiming;
using testing::mend_checksum;
using ::testing::SizeIs;

MadeEdid desk_monitor() {
    MadeEdid made;
    made.vendor = "DEL";
    made.product = 0xa0b3;
    made.serial = 0x30364c53;
    made.year = 2012;
    made.width_cm = 52;
    made.height_cm = 32;
    made.name = "DELL U2412M";
    made.serial_text = "YMYH14CF60LS";
    made.timing = MadeTiming{15400, 1920, 160, 1200, 35, 518, 324};
    made.has_hdmi = false;
    return made;
}

TEST(ReadEdid, KnowsADeskMonitor) {
    const auto edid = read_edid(bytes_of(desk_monitor()));
    ASSERT_TRUE(edid);
    EXPECT_EQ(edid->vendor, "DEL");
    EXPECT_EQ(edid->product, 0xa0b3);
    EXPECT_EQ(edid->serial, 0x30364c53U);
    EXPECT_EQ(edid->year, 2012);
    EXPECT_EQ(edid->name, "DELL U2412M");
    EXPECT_EQ(edid->serial_text, "YMYH14CF60LS");
    EXPECT_EQ(edid->native, (Size{1920, 1200}));
    EXPECT_NEAR(edid->native_hz, 59.95, 0.01);
    EXPECT_EQ(edid->size_mm, (Size{518, 324}));
    EXPECT_TRUE(edid->is_digital);
    EXPECT_FALSE(edid->is_hdmi);
    EXPECT_THAT(edid->faults, IsEmpty());
    EXPECT_EQ(identity_of(edid), "DEL 0xa0b3 'DELL U2412M' serial YMYH14CF60LS");
}

TEST(ReadEdid, KnowsAProjectorOnHdmiWithoutASize) {
    const auto edid = read_edid(bytes_of(MadeEdid{}));
    ASSERT_TRUE(edid);
    EXPECT_EQ(edid->native, (Size{1920, 1080}));
    EXPECT_NEAR(edid->native_hz, 60.0, 0.01);
    EXPECT_EQ(edid->size_mm, Size{});
    EXPECT_TRUE(edid->is_hdmi);
    EXPECT_THAT(edid->faults, IsEmpty());
    EXPECT_EQ(identity_of(edid), "EPS 0x1234 'EPSON PJ'");
}

TEST(ReadEdid, TakesAnAspectRatioInPlaceOfMillimetresForNoSize) {
    MadeEdid television;
    television.width_cm = 16;
    television.height_cm = 0;
    television.timing.width_mm = 16;
    television.timing.height_mm = 9;
    EXPECT_EQ(read_edid(bytes_of(television))->size_mm, Size{});
}

TEST(ReadEdid, RefusesWhatIsNone) {
    EXPECT_FALSE(read_edid({}));
    EXPECT_FALSE(read_edid(std::vector<std::uint8_t>(128, 0)));
    EXPECT_FALSE(read_edid(std::vector<std::uint8_t>(256, 0xff))) << "what a cable without a data line reads as";
    auto cut = bytes_of(MadeEdid{});
    cut.resize(127);
    EXPECT_FALSE(read_edid(cut));
    EXPECT_EQ(identity_of(std::nullopt), "no EDID");
}

TEST(ReadEdid, ReadsOnPastAWrongChecksumAndNamesIt) {
    auto bytes = bytes_of(MadeEdid{});
    bytes[127] ^= 1;
    bytes[200] ^= 1;
    const auto edid = read_edid(bytes);
    ASSERT_TRUE(edid);
    EXPECT_EQ(edid->name, "EPSON PJ");
    EXPECT_FALSE(edid->is_hdmi) << "an extension that cannot be trusted is not read";
    EXPECT_THAT(edid->faults, ElementsAre(HasSubstr("checksum"), HasSubstr("extension 1")));
}

TEST(ReadEdid, NamesExtensionsThatWerePromisedAndDidNotCome) {
    auto bytes = bytes_of(MadeEdid{});
    bytes.resize(128);
    EXPECT_THAT(read_edid(bytes)->faults, ElementsAre(HasSubstr("1 of 1 extensions are missing")));
}

TEST(ReadEdid, StopsAtADataBlockThatRunsOutOfItsExtension) {
    auto bytes = bytes_of(MadeEdid{});
    bytes[128 + 4] = 0x7f;  // 31 bytes, where 10 are left
    mend_checksum(bytes, 1);
    const auto edid = read_edid(bytes);
    EXPECT_THAT(edid->faults, ElementsAre(HasSubstr("data block")));
    EXPECT_FALSE(edid->is_hdmi);
}

TEST(ReadEdid, NamesAVendorThatIsNotThreeLettersAndATimingWithoutPixels) {
    auto bytes = bytes_of(MadeEdid{});
    bytes[8] = 0;
    bytes[9] = 0;
    for (std::size_t i = 56; i < 62; ++i) bytes[i] = 0;
    mend_checksum(bytes, 0);
    const auto edid = read_edid(bytes);
    EXPECT_EQ(edid->vendor, "???");
    EXPECT_FALSE(edid->native);
    EXPECT_THAT(edid->faults, SizeIs(2));
}

TEST(ReadEdid, KeepsOnlyWhatPrintsOfANameFullOfRubbish) {
    MadeEdid made;
    made.name = std::string("TV\x01\xfe  ") + "X";
    EXPECT_EQ(read_edid(bytes_of(made))->name, "TV??  X");
}

TEST(ReadEdid, SurvivesAnyBytesAfterARightHeader) {
    base::RandomStream random{base::Seed{1}.child("edid")};
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::uint8_t> bytes(128 + random.below(400));
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
        for (std::size_t i = 0; i < 8; ++i) bytes[i] = i % 7 == 0 ? 0 : 255;
        const auto edid = read_edid(bytes);
        ASSERT_TRUE(edid);
        EXPECT_LE(edid->name.size(), 13U);
        EXPECT_THAT(identity_of(edid), ::testing::Not(IsEmpty()));
    }
}

TEST(FingerprintOfEdid, DiffersWhenAnyOneByteDoes) {
    const auto bytes = bytes_of(desk_monitor());
    const auto whole = fingerprint_of(bytes);
    EXPECT_NE(whole, 0U);
    EXPECT_EQ(fingerprint_of({}), 0U);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        auto other = bytes;
        other[i] ^= 0x10;
        EXPECT_NE(fingerprint_of(other), whole) << i;
    }
}

}  // namespace
}  // namespace quadrat::display
