// SPDX-License-Identifier: Apache-2.0
#include "pictures/images/tiff_nodata.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "base/file.hpp"
#include "pictures/image_file.hpp"
#include "support/process.hpp"

namespace quadrat::pictures {
namespace {

struct Form {
    bool is_little;
    std::uint64_t word;  // 4; 8 is BigTIFF
};

std::string number(std::uint64_t value, std::uint64_t size, const Form& form) {
    std::string bytes;
    for (std::uint64_t i = 0; i < size; ++i)
        bytes += static_cast<char>(value >> 8U * (form.is_little ? i : size - 1 - i) & 0xffU);
    return bytes;
}

// A TIFF of a directory alone: a width, and this text with GDAL's tag.
std::string tiff_saying(const std::string& text, const Form& form) {
    const std::uint64_t start = form.word == 4 ? 8 : 16, count_size = form.word == 4 ? 2 : 8;
    std::string bytes = form.is_little ? "II" : "MM";
    bytes += number(form.word == 4 ? 42 : 43, 2, form);
    if (form.word == 8) bytes += number(8, 2, form) + number(0, 2, form);
    bytes += number(start, form.word, form) + number(2, count_size, form);
    bytes += number(256, 2, form) + number(4, 2, form) + number(1, form.word, form) + number(99, form.word, form);
    bytes += number(42113, 2, form) + number(2, 2, form) + number(text.size() + 1, form.word, form);
    const bool is_inside = text.size() < form.word;
    const std::uint64_t behind = start + count_size + 2 * (4 + 2 * form.word) + form.word;
    bytes += is_inside ? (text + std::string(form.word, '\0')).substr(0, form.word) : number(behind, form.word, form);
    return bytes + number(0, form.word, form) + text + '\0';
}

TEST(TiffNodata, IsFoundInBothOrdersOfBytesAndInBigTiffs) {
    for (const Form form : {Form{true, 4}, Form{false, 4}, Form{true, 8}, Form{false, 8}}) {
        EXPECT_EQ(nodata_of_tiff(tiff_saying("-9999", form)), -9999.0F);
        EXPECT_EQ(nodata_of_tiff(tiff_saying("-3.4028234663852886e+38", form)), -3.4028234663852886e+38F);
        EXPECT_EQ(nodata_of_tiff(tiff_saying("0", form)), 0.0F);
        EXPECT_EQ(nodata_of_tiff(tiff_saying("+32767 ", form)), 32767.0F);
        for (const char* none : {"", "nan", "inf", "-1.8e+308", "none", "12x"})
            EXPECT_EQ(nodata_of_tiff(tiff_saying(none, form)), std::nullopt) << none;
    }
}

TEST(TiffNodata, IsNoneInWhatIsCutOrNoTiff) {
    const Form form{true, 4};
    const std::string whole = tiff_saying("-9999", form);
    for (std::size_t size = 0; size + 6 < whole.size(); ++size)
        EXPECT_EQ(nodata_of_tiff(whole.substr(0, size)), std::nullopt) << size;
    EXPECT_EQ(nodata_of_tiff("\x89PNG\r\n"), std::nullopt);
}

// A directory with one more entry, behind the others: their tags are lower.
std::string with_nodata(std::string tiff, const std::string& text) {
    const Form form{tiff.starts_with("II"), 4};
    const auto read = [&](std::size_t at, std::size_t size) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8U | static_cast<std::uint8_t>(tiff[at + (form.is_little ? size - 1 - i : i)]);
        return value;
    };
    const std::size_t old = read(4, 4), count = read(old, 2);
    const std::string entries = tiff.substr(old + 2, 12 * count);
    if (tiff.size() % 2 != 0) tiff += '\0';
    const std::size_t text_at = tiff.size();
    tiff += text + '\0';
    if (tiff.size() % 2 != 0) tiff += '\0';
    tiff.replace(4, 4, number(tiff.size(), 4, form));
    return tiff + number(count + 1, 2, form) + entries + number(42113, 2, form) + number(2, 2, form) +
           number(text.size() + 1, 4, form) + number(text_at, 4, form) + number(0, 4, form);
}

TEST(TiffNodata, OfAnElevationModelComesWithItsPicture) {
    const tests::TemporaryFolder folder;
    mesh::Field field(9, 9);
    field.samples[40] = -7;
    const std::string bytes = encoded_field("a.tif", field);
    ASSERT_TRUE(bytes.starts_with("II*") || bytes.starts_with("MM"));
    EXPECT_EQ(read_grey_picture(folder.write("plain.tif", bytes)).nodata, std::nullopt);
    const GreyPicture picture = read_grey_picture(folder.write("told.tif", with_nodata(bytes, "-7.0000")));
    EXPECT_EQ(picture.nodata, -7.0F);
    EXPECT_EQ(picture.samples.samples[40], -7.0F);
}

}  // namespace
}  // namespace quadrat::pictures
