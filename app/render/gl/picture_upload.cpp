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

void add_levels(Slices& slices, Texture2D& texture, const std::shared_ptr<Chain>& chain, int width, int height,
                int channels) {
    for (int level = 0;; ++level) {
        add_level(slices, texture, chain, level, width, height, channels);
        if (width == 1 && height == 1) return;
        slices.add(static_cast<std::size_t>(width * height * channels),
                   [chain] { chain->level = std::make_shared<mesh::Image>(halved(*chain->level)); });
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
    }
}

TextureShape shape_of(int width, int height, int channels, Meaning meaning, Wrap wrap_s, Wrap wrap_t) {
    return {width, height, channels, meaning, wrap_s, wrap_t, Mipmaps::Whole};
}

}  // namespace

void add_picture(Slices& slices, Texture2D& texture, std::shared_ptr<const mesh::Image> image, Meaning meaning,
                 Wrap wrap_s, Wrap wrap_t) {
    const auto chain = std::make_shared<Chain>(Chain{std::move(image)});
    const mesh::Image& whole = *chain->level;
    const TextureShape shape = shape_of(whole.width, whole.height, whole.channels, meaning, wrap_s, wrap_t);
    slices.add(0, [&texture, shape] { texture = Texture2D{shape}; });
    add_levels(slices, texture, chain, shape.width, shape.height, shape.channels);
}

void add_painting(Slices& slices, Texture2D& texture, int width, int height, int channels, Meaning meaning, Wrap wrap_s,
                  Wrap wrap_t, const std::function<void(mesh::Image&, int row)>& paint) {
    const auto picture = std::make_shared<mesh::Image>(width, height, channels);
    const auto chain = std::make_shared<Chain>(Chain{picture});
    const TextureShape shape = shape_of(width, height, channels, meaning, wrap_s, wrap_t);
    slices.add(0, [&texture, shape] { texture = Texture2D{shape}; });
    const int band = std::max(1, rows_a_slice(width * channels) / 4);
    slices.add_pieces(static_cast<std::size_t>(height), static_cast<std::size_t>(band),
                      static_cast<std::size_t>(width * channels) * 4,
                      [picture, paint](std::size_t row, std::size_t rows) {
                          for (std::size_t r = row; r < row + rows; ++r) paint(*picture, static_cast<int>(r));
                      });
    add_levels(slices, texture, chain, width, height, channels);
}

}  // namespace quadrat::render::gl
