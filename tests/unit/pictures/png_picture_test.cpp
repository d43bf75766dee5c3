// SPDX-License-Identifier: Apache-2.0
#include "pictures/png_picture.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/process.hpp"

namespace quadrat::pictures {
namespace {

TEST(PngPicture, IsReadAsItWasWrittenAndOpaque) {
    const tests::TemporaryFolder folder;
    mesh::Image image(5, 3, 4);
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = static_cast<std::uint8_t>(11 * i);
    write_png_quickly(folder / "a.png", image);
    const mesh::Image again = read_png_quickly(folder / "a.png");
    ASSERT_EQ(again.width, 5);
    ASSERT_EQ(again.height, 3);
    for (std::size_t i = 0; i < image.bytes.size(); ++i)
        EXPECT_EQ(again.bytes[i], i % 4 == 3 ? 255 : image.bytes[i]) << i;
}

TEST(PngPicture, OfADamagedFileOrNoneIsAnErrorThatNamesIt) {
    const tests::TemporaryFolder folder;
    folder.write("cut.png", "\x89PNG\r\n\x1a\n and no more");
    EXPECT_THROW(read_png_quickly(folder / "cut.png"), base::InputError);
    EXPECT_THROW(read_png_quickly(folder / "none.png"), base::InputError);
    EXPECT_THROW(write_png_quickly(folder / "no/such/folder.png", mesh::Image(2, 2, 4)), base::InputError);
}

}  // namespace
}  // namespace quadrat::pictures
