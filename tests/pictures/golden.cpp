// SPDX-License-Identifier: Apache-2.0
#include "pictures/golden.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace quadrat::tests {
namespace {

// Rasterisers of two Mesa versions round differently along edges: single pixels may differ much, the picture may not.
constexpr float kMeanTolerance = 0.006F;   // of the whole range
constexpr float kPixelTolerance = 0.06F;   // beyond which a pixel counts as different
constexpr float kDifferentShare = 0.015F;  // of all pixels

OIIO::ImageBuf buffer_of(const mesh::Image& image) {
    const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    OIIO::ImageBuf buffer(spec);
    buffer.set_pixels(OIIO::ROI(0, image.width, 0, image.height, 0, 1, 0, 3), OIIO::TypeDesc::UINT8, image.bytes.data(),
                      4, image.width * 4);
    return buffer;
}

void write_png(const OIIO::ImageBuf& buffer, const std::filesystem::path& path) {
    std::filesystem::create_directories(path.parent_path());
    ASSERT_TRUE(buffer.write(path.string())) << path << ": " << buffer.geterror();
    // OpenImageIO does not tell of a disk that is full.
    const OIIO::ImageBuf written(path.string());
    ASSERT_EQ(OIIO::ImageBufAlgo::compare(buffer, written, 0, 0).maxerror, 0) << path << " is not what was drawn";
}

}  // namespace

void expect_golden(const std::string& name, const mesh::Image& picture) {
    const std::filesystem::path golden =
        std::filesystem::path(QUADRAT_SOURCE_DIR) / "tests/pictures/golden" / (name + ".png");
    const OIIO::ImageBuf now = buffer_of(picture);
    const char* is_making = std::getenv("QUADRAT_MAKE_GOLDENS");
    if (is_making && std::string{is_making} == "1") {
        write_png(now, golden);
        return;
    }
    const OIIO::ImageBuf then(golden.string());
    ASSERT_TRUE(then.initialized()) << golden << " cannot be read; QUADRAT_MAKE_GOLDENS=1 makes it";
    ASSERT_EQ(then.spec().width, picture.width) << golden;
    ASSERT_EQ(then.spec().height, picture.height) << golden;
    const auto difference = OIIO::ImageBufAlgo::compare(now, then, kPixelTolerance, kPixelTolerance);
    const double share = static_cast<double>(difference.nfail) /
                         (static_cast<double>(picture.width) * static_cast<double>(picture.height));
    const auto left = std::filesystem::path(QUADRAT_BINARY_DIR) / "pictures" / (name + ".png");
    const bool is_same =
        difference.meanerror <= static_cast<double>(kMeanTolerance) && share <= static_cast<double>(kDifferentShare);
    if (!is_same) write_png(now, left);
    EXPECT_TRUE(is_same) << name << ": mean difference " << difference.meanerror << " (at most " << kMeanTolerance
                         << "), " << 100 * share << " % of the pixels differ by more than " << kPixelTolerance
                         << " (at most " << 100 * kDifferentShare << " %), largest " << difference.maxerror
                         << "; drawn: " << left;
}

}  // namespace quadrat::tests
