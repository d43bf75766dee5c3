// SPDX-License-Identifier: Apache-2.0
#include "render/gl/picture_upload.hpp"

#include <algorithm>

namespace quadrat::render::gl {
namespace {

constexpr std::size_t kSliceBytes = 256U << 10U;

// The level that is being written; each slice of the next one starts from it.
struct Chain {
    std::shared_ptr<const mesh::Image> level;
};

int rows_a_slice(int row_bytes) { return std::max(1, static_cast<int>(kSliceBytes) / std::max(row_bytes, 1)); }

void add_level(Slices& slices, Texture2D& texture, const std::shared_ptr<Chain>& chain, int level, int width,
               int height, int channels) {
    const int row_bytes = width * channels;
    const int band = rows_a_slice(row_bytes);
    for (int row = 0; row < height; row += band) {
        const int rows = std::min(band, height - row);
        slices.add(static_cast<std::size_t>(rows * row_bytes), [&texture, chain, level, row, rows, row_bytes] {
            const auto* first = chain->level->pixel(0, row);
            texture.write_rows(level, row, rows, {first, static_cast<std::size_t>(rows * row_bytes)});
        });
    }
}

void add_levels(Slices& slices, Texture2D& texture, const std::shared_ptr<Chain>& chain, const TextureShape& shape) {
    int width = shape.width;
    int height = shape.height;
    for (int level = 0; level < shape.levels(); ++level) {
        add_level(slices, texture, chain, level, width, height, shape.channels);
        slices.add(static_cast<std::size_t>(width * height * shape.channels),
                   [chain] { chain->level = std::make_shared<mesh::Image>(halved(*chain->level)); });
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
    }
}

}  // namespace

std::shared_ptr<const mesh::Image> add_painting(Slices& slices, Texture2D& texture, const TextureShape& shape,
                                                const Painter& paint) {
    const auto picture = std::make_shared<mesh::Image>(shape.width, shape.height, shape.channels);
    slices.add(0, [&texture, shape] { texture = Texture2D{shape}; });
    // Painting a byte takes longer than moving one.
    const int row_bytes = 4 * shape.width * shape.channels;
    slices.add_pieces(static_cast<std::size_t>(shape.height), static_cast<std::size_t>(rows_a_slice(row_bytes)),
                      static_cast<std::size_t>(row_bytes), [picture, paint](std::size_t row, std::size_t rows) {
                          for (std::size_t r = row; r < row + rows; ++r) paint(*picture, static_cast<int>(r));
                      });
    add_levels(slices, texture, std::make_shared<Chain>(Chain{picture}), shape);
    return picture;
}

void add_picture(Slices& slices, Texture2D& texture, std::shared_ptr<const mesh::Image> image,
                 const TextureShape& wanted) {
    TextureShape shape = wanted;
    shape.width = image->width;
    shape.height = image->height;
    shape.channels = image->channels;
    slices.add(0, [&texture, shape] { texture = Texture2D{shape}; });
    add_levels(slices, texture, std::make_shared<Chain>(Chain{std::move(image)}), shape);
}

}  // namespace quadrat::render::gl
