// SPDX-License-Identifier: Apache-2.0
#include "staff/postcards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pictures/png_picture.hpp"
#include "support/process.hpp"

namespace quadrat::staff {
namespace {

using testing::HasSubstr;

mesh::Image grey(int width, int height) {
    mesh::Image image(width, height, 4);
    std::ranges::fill(image.bytes, std::uint8_t{128});
    return image;
}

class APrinter : public testing::Test {
  protected:
    std::string lp(const std::string& text) {
        folder_.write("lp", "#!/bin/sh\n" + text);
        std::filesystem::permissions(folder_ / "lp", std::filesystem::perms::owner_all);
        return (folder_ / "lp").string();
    }
    tests::TemporaryFolder folder_;
};

TEST_F(APrinter, IsGivenTheCardAsAFileThatIsGoneAfterwards) {
    const std::string program = lp("echo \"$@\" >" + (folder_ / "asked").string() +
                                   "\nfor last; do :; done\ncp \"$last\" " + (folder_ / "card.png").string() + "\n");
    EXPECT_EQ(print(grey(40, 30), "cards", program), "");
    EXPECT_EQ(pictures::read_png_quickly(folder_ / "card.png").width, 40);
    const std::string asked = tests::contents_of(folder_ / "asked");
    EXPECT_THAT(asked, testing::StartsWith("-d cards -t Quadrat "));
    const std::string file = asked.substr(asked.rfind(' ') + 1, asked.size() - asked.rfind(' ') - 2);
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(file).parent_path())) << file;
}

TEST_F(APrinter, ThatIsMissingSaysSoInOneLine) {
    const std::string program = lp("echo 'lp: no such printer' >&2\necho 'try another' >&2\nexit 1\n");
    EXPECT_EQ(print(grey(4, 3), "cards", program), "printer cards: lp: no such printer try another");
    EXPECT_EQ(print(grey(4, 3), "cards", lp("exit 3\n")), "printer cards: lp failed");
    EXPECT_THAT(print(grey(4, 3), "cards", "/nowhere/lp"), HasSubstr("apt install cups-client"));
}

TEST_F(APrinter, MaySayMuchAndIsStillHeardToItsEnd) {
    const std::string program = lp("i=0\nwhile [ $i -lt 20000 ]; do echo 0123456789; i=$((i+1)); done\nexit 1\n");
    EXPECT_LT(print(grey(4, 3), "cards", program).size(), 1200U);
}

TEST(ABlankCard, HasThePlaceAndTheDateBelow) {
    site::Configuration configuration;
    configuration.postcard.place = "Museum";
    const pictures::Postcard card = blank_card(configuration, "flat land", "Qcode", "ar");
    EXPECT_THAT(card.below, testing::StartsWith("Museum · \u206620"));
    EXPECT_TRUE(card.reads_right_to_left);
    EXPECT_EQ(card.title, "flat land");
    EXPECT_FALSE(blank_card(configuration, "", "", "en").reads_right_to_left);
}

TEST(APostcardsLandscape, IsTheMiddleOfThePictureAsLargeAsTheCardHasRoomFor) {
    mesh::Image picture(320, 180, 4);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) {
            std::uint8_t* pixel = picture.pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(x * 255 / 319);
            pixel[1] = static_cast<std::uint8_t>(y * 255 / 179);
            pixel[2] = 0;
            pixel[3] = 255;
        }
    const mesh::Image filled = pictures::filling_postcard(picture);
    ASSERT_EQ(filled.width, pictures::kOnPostcard_px.x);
    ASSERT_EQ(filled.height, pictures::kOnPostcard_px.y);
    EXPECT_NEAR(filled.pixel(0, 0)[0], 0, 1);
    EXPECT_NEAR(filled.pixel(filled.width - 1, 0)[0], 255, 1);
    // 320 x 137.6 of it: 21.2 rows are left out above and below.
    EXPECT_NEAR(filled.pixel(0, 0)[1], 21.2 / 179 * 255, 2);
    EXPECT_NEAR(filled.pixel(0, filled.height / 2)[1], 127, 2);
    EXPECT_EQ(pictures::filling_postcard(filled), filled);
}

}  // namespace
}  // namespace quadrat::staff
