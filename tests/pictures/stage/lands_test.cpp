// SPDX-License-Identifier: Apache-2.0
// The shapes of land that the genes must reach: a recipe each in tests/pictures/lands. What they look like is judged by
// eye, on lands.png in the build folder; that they are lands of their own, here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "pictures/picture.hpp"
#include "stage/easel.hpp"

namespace quadrat::stage {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 270;

double mean_difference(const mesh::Image& a, const mesh::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) sum += std::abs(int{a.bytes[i]} - int{b.bytes[i]});
    return sum / static_cast<double>(a.bytes.size());
}

TEST(Lands, OfEveryShapeAreWithinReachAndUnlikeEachOther) {
    Easel easel(kWidth, kHeight);
    std::vector<pictures::SheetEntry> sheet;
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(QUADRAT_SOURCE_DIR) / "tests/pictures/lands"))
        files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_GE(files.size(), 10U);
    for (const auto& file : files) {
        pictures::Picture picture = pictures::read_scene(file.string());
        picture.width = kWidth;
        picture.height = kHeight;
        sheet.push_back({easel.draw(picture), file.stem().string()});
    }
    for (std::size_t i = 0; i < sheet.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(mean_difference(sheet[i].pixels, sheet[k].pixels), 8)
                << sheet[i].caption << " and " << sheet[k].caption;
    pictures::write_image(std::filesystem::path(QUADRAT_BINARY_DIR) / "lands.png",
                          pictures::contact_sheet(sheet, 2, kWidth));
}

}  // namespace
}  // namespace quadrat::stage
