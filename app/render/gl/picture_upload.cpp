// SPDX-License-Identifier: Apache-2.0
#include "render/gl/picture_upload.hpp"

#include <algorithm>
#include <vector>

namespace quadrat::render::gl {
namespace {

constexpr std::size_t kSliceBytes = 256U << 10U;

using Levels = std::vector<std::shared_ptr<const mesh::Image>>;

int rows_a_slice(int row_bytes) { return std::max(1, static_cast<int>(kSliceBytes) / std::max(row_bytes, 1)); }

// Of picture, which is whole when this is its turn among what is prepared, into what find() gives once it is made.
template <typename Find>
void add_levels(Slices& slices, const std::shared_ptr<const mesh::Image>& picture, const TextureShape& shape,
                const std::function<void()>& make, const Find& find) {
    const auto levels = std::make_shared<Levels>();
    slices.prepare([levels, picture, count = shape.levels()] {
        levels->push_back(picture);
        for (int level = 1; level < count; ++level)
            levels->push_back(std::make_shared<mesh::Image>(halved(*levels->back())));
    });
    slices.add(0, make);
    int width = shape.width;
    int height = shape.height;
    for (int level = 0; level < shape.levels(); ++level) {
        const int row_bytes = width * shape.channels;
        const int band = rows_a_slice(row_bytes);
        for (int row = 0; row < height; row += band) {
            const int rows = std::min(band, height - row);
            slices.add(static_cast<std::size_t>(rows * row_bytes), [find, levels, level, row, rows, row_bytes] {
                const mesh::Image& image = *(*levels)[static_cast<std::size_t>(level)];
                find().write_rows(level, row, rows, {image.pixel(0, row), static_cast<std::size_t>(rows * row_bytes)});
            });
        }
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
    }
}

}  // namespace

std::shared_ptr<const mesh::Image> add_painting(Slices& slices, std::shared_ptr<const Texture2D>& texture,
                                                const std::shared_ptr<TexturePool>& pool, const TextureShape& shape,
                                                const Painter& paint) {
    const auto picture = std::make_shared<mesh::Image>();
    slices.prepare([picture, shape, paint] {
        *picture = mesh::Image(shape.width, shape.height, shape.channels);
        for (int row = 0; row < picture->height; ++row) paint(*picture, row);
    });
    add_levels(
        slices, picture, shape, [&texture, pool, shape] { texture = pool->take(shape); },
        [&texture]() -> const Texture2D& { return *texture; });
    return picture;
}

void add_picture(Slices& slices, Texture2D& texture, const std::shared_ptr<const mesh::Image>& image,
                 const TextureShape& wanted) {
    TextureShape shape = wanted;
    shape.width = image->width;
    shape.height = image->height;
    shape.channels = image->channels;
    add_levels(
        slices, image, shape, [&texture, shape] { texture = Texture2D{shape}; },
        [&texture]() -> const Texture2D& { return texture; });
}

}  // namespace quadrat::render::gl
