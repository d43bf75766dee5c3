// SPDX-License-Identifier: Apache-2.0
#include "pictures/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "machine/measurement.hpp"
#include "pictures/image_file.hpp"
#include "support/process.hpp"

namespace quadrat::pictures {
namespace {

Picture sample_picture(std::size_t scenes) {
    Picture picture;
    for (std::size_t i = 0; i < scenes; ++i) picture.scenes.push_back(genome::random_recipe(base::Seed{i}));
    picture.width = 640;
    picture.height = 360;
    picture.seconds = 12.345F;
    picture.growth = 0.3F;
    picture.alpha = 0.7F;
    return picture;
}

TEST(Picture, ItsJsonSaysAllThatDecidesIt) {
    for (const std::size_t scenes : {1U, 4U}) {
        Picture picture = sample_picture(scenes);
        EXPECT_EQ(picture_from_json(to_json(picture), "x"), picture);
        picture.ground = render::GroundBy::Roam;
        EXPECT_EQ(picture_from_json(to_json(picture), "x").ground, render::GroundBy::Roam);
        picture.samples = 4;
        EXPECT_EQ(picture_from_json(to_json(picture), "x").samples, 4);
        picture.camera = scene::Camera{{1, 2, 3}, {4.5F, 0.1F, -7}, 33};
        EXPECT_EQ(picture_from_json(to_json(picture), "x"), picture);
    }
}

TEST(Picture, ASceneFileIsAPictureOfIt) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{4});
    const Picture picture = picture_from_json(genome::to_json(recipe), "x");
    ASSERT_EQ(picture.scenes.size(), 1U);
    EXPECT_EQ(picture.scenes.front(), recipe);
}

TEST(Picture, IsFoundAgainInsideAPng) {
    const tests::TemporaryFolder folder;
    const Picture picture = sample_picture(4);
    mesh::Image pixels(8, 4, 4);
    for (std::size_t i = 0; i < pixels.bytes.size(); ++i)
        pixels.bytes[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 7 * i);
    write_picture(folder / "a.png", pixels, to_json(picture));
    EXPECT_EQ(read_scene((folder / "a.png").string()), picture);
    EXPECT_EQ(read_image_file(folder / "a.png"), pixels);
    write_image(folder / "b.png", pixels);
    EXPECT_THROW(read_scene((folder / "b.png").string()), base::InputError);
}

TEST(Picture, RefusesWhatItCannotBe) {
    const auto refusal = [](const std::string& json) -> std::string {
        try {
            picture_from_json(json, "p.json");
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    using testing::HasSubstr;
    EXPECT_THAT(refusal(R"({"quadrat":"picture","version":9})"), HasSubstr("version 9"));
    EXPECT_THAT(refusal(R"({"quadrat":"picture","version":1,"scenes":[]})"), HasSubstr("one scene or four"));
    std::string json = to_json(sample_picture(1));
    json.replace(json.find("640"), 3, "-64");
    EXPECT_THAT(refusal(json), HasSubstr("width is -64"));
    Picture other = sample_picture(1);
    other.ground = render::GroundBy::Roam;
    json = to_json(other);
    json.replace(json.find("roam"), 4, "mole");
    EXPECT_THAT(refusal(json), HasSubstr("ground is \"mole\"; it must be blocks or roam"));
    other.samples = 3;
    EXPECT_THAT(refusal(to_json(other)), HasSubstr("samples is 3; it must be 1 or 4"));
}

TEST(ContactSheet, HoldsEveryPictureInRowsAndCaptions) {
    std::vector<SheetEntry> entries(5);
    for (auto& entry : entries) {
        entry.pixels = mesh::Image(64, 36, 4);
        std::fill(entry.pixels.bytes.begin(), entry.pixels.bytes.end(), std::uint8_t{200});
        entry.caption = "Round";
    }
    const mesh::Image sheet = contact_sheet(entries, 3, 32);
    EXPECT_GT(sheet.width, 3 * 32);
    EXPECT_GT(sheet.height, 2 * 18);
    EXPECT_EQ(sheet.pixel(20, 20)[0], 200);
    EXPECT_EQ(sheet.pixel(sheet.width - 2, sheet.height - 2)[3], 255);
    EXPECT_EQ(contact_sheet({}, 3, 32).width, 0);
}

TEST(Percentile, IsTheNearestRank) {
    EXPECT_EQ(machine::percentile({3, 1, 2}, 0.5), 2);
    EXPECT_EQ(machine::percentile({3, 1, 2}, 0.99), 3);
    EXPECT_EQ(machine::percentile({3, 1, 2, 4}, 0.25), 1);
    EXPECT_EQ(machine::percentile({}, 0.5), 0);
}

}  // namespace
}  // namespace quadrat::pictures
