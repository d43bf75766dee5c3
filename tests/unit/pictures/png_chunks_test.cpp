// SPDX-License-Identifier: Apache-2.0
#include "pictures/images/png_chunks.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "pictures/image_file.hpp"
#include "pictures/picture.hpp"
#include "support/process.hpp"

namespace quadrat::pictures {
namespace {

std::string in_four_bytes(std::size_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> static_cast<unsigned>(shift));
    return bytes;
}

std::string chunk(const std::string& kind, const std::string& data) {
    const std::string summed = kind + data;
    const uLong sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(summed.data()), summed.size());
    return in_four_bytes(data.size()) + summed + in_four_bytes(sum);
}

// As some editors save it: what is known of a picture after its pixels.
std::string with_text_last(std::string png, const std::string& text_chunk) {
    return png.insert(png.size() - 12, text_chunk);
}

mesh::Image chequered() {
    mesh::Image image(64, 36, 4);
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 64);
    return image;
}

TEST(PngChunks, TellEveryCutAndEveryDamage) {
    const std::string png = encoded_picture("a.png", chequered(), "{}");
    EXPECT_EQ(damage_of_png(png), "");
    for (std::size_t size = 0; size < png.size(); ++size) ASSERT_NE(damage_of_png(png.substr(0, size)), "") << size;
    for (std::size_t at = 0; at < png.size(); at += 5) {
        std::string damaged = png;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
        EXPECT_NE(damage_of_png(damaged), "") << at;
    }
}

TEST(PngChunks, TextsComeBeforePixelsAndNothingElseMoves) {
    const std::string png = encoded_picture("a.png", chequered(), "");
    const std::string text = chunk("tEXt", std::string("Author\0me", 9));
    const std::string moved = with_texts_first(with_text_last(png, text));
    EXPECT_EQ(damage_of_png(moved), "");
    EXPECT_EQ(moved.size(), png.size() + text.size());
    EXPECT_LT(moved.find("tEXtAuthor"), moved.find("IDAT"));
    EXPECT_EQ(with_texts_first(png), png);
    EXPECT_EQ(with_texts_first("no PNG"), "no PNG");
}

TEST(PngChunks, ASceneIsReadFromAPictureWhoseTextsComeLast) {
    const tests::TemporaryFolder folder;
    Picture picture;
    picture.scenes.push_back(genome::random_recipe(base::Seed{3}));
    picture.width = 64;
    picture.height = 36;
    const std::string png = encoded_picture("a.png", chequered(), "");
    for (const std::string& text : {chunk("tEXt", "quadrat:scene" + std::string(1, '\0') + to_json(picture)),
                                    chunk("iTXt", "quadrat:scene" + std::string(5, '\0') + to_json(picture))}) {
        const auto file = folder.write("late.png", with_text_last(png, text));
        EXPECT_EQ(read_scene(file.string()), picture);
    }
}

TEST(Pictures, AreTheSameBytesWheneverTheyAreWrittenAndCarryNoDate) {
    const mesh::Field field(33, 33);
    for (const char* name : {"a.exr", "a.tif"}) {
        const std::string bytes = encoded_field(name, field);
        EXPECT_EQ(bytes.find("20:"), std::string::npos) << name << " has a time of day";
        EXPECT_EQ(bytes, encoded_field(name, field));
    }
    EXPECT_EQ(encoded_picture("a.exr", chequered(), "{}").find(":20"), std::string::npos);
}

}  // namespace
}  // namespace quadrat::pictures
