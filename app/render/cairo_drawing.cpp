// SPDX-License-Identifier: Apache-2.0
#include "render/cairo_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/field.hpp"

namespace quadrat::render {
namespace {

constexpr float kHaloDarkness = 0.72F;

void blur_line(std::vector<float>& line, std::vector<float>& sums, int radius) {
    const int n = static_cast<int>(line.size());
    sums[0] = 0;
    for (int i = 0; i < n; ++i)
        sums[static_cast<std::size_t>(i) + 1] = sums[static_cast<std::size_t>(i)] + line[static_cast<std::size_t>(i)];
    for (int i = 0; i < n; ++i) {
        const int low = std::max(i - radius, 0);
        const int high = std::min(i + radius + 1, n);
        line[static_cast<std::size_t>(i)] =
            (sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)]) /
            static_cast<float>(2 * radius + 1);
    }
}

// Three boxes after one another are nearly a Gaussian.
void blur(mesh::Field& field, int radius) {
    if (radius < 1) return;
    std::vector<float> line;
    std::vector<float> sums(static_cast<std::size_t>(std::max(field.columns, field.rows)) + 1);
    for (int pass = 0; pass < 3; ++pass) {
        for (int row = 0; row < field.rows; ++row) {
            line.assign(&field.at(0, row), &field.at(0, row) + field.columns);
            blur_line(line, sums, radius);
            std::ranges::copy(line, &field.at(0, row));
        }
        line.resize(static_cast<std::size_t>(field.rows));
        for (int column = 0; column < field.columns; ++column) {
            for (int row = 0; row < field.rows; ++row) line[static_cast<std::size_t>(row)] = field.at(column, row);
            blur_line(line, sums, radius);
            for (int row = 0; row < field.rows; ++row) field.at(column, row) = line[static_cast<std::size_t>(row)];
        }
    }
}

}  // namespace

mesh::Image image_of(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    mesh::Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), 4);
    const unsigned char* rows = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t word = 0;
            std::copy_n(rows + y * stride + x * 4, 4, reinterpret_cast<unsigned char*>(&word));
            std::uint8_t* out = image.pixel(x, y);
            out[0] = static_cast<std::uint8_t>(word >> 16U);
            out[1] = static_cast<std::uint8_t>(word >> 8U);
            out[2] = static_cast<std::uint8_t>(word);
            out[3] = static_cast<std::uint8_t>(word >> 24U);
        }
    }
    return image;
}

Surface new_surface(int width, int height) {
    return Surface{cairo_image_surface_create(CAIRO_FORMAT_ARGB32, std::max(width, 1), std::max(height, 1))};
}

// Blurred, then hardened: soft outside, full beneath.
void put_halo_under(mesh::Image& image, float radius_px) {
    mesh::Field halo(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) halo.at(x, y) = static_cast<float>(image.pixel(x, y)[3]) / 255;
    blur(halo, std::max(1, static_cast<int>(std::lround(radius_px * 0.6F))));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint8_t* pixel = image.pixel(x, y);
            const float over = static_cast<float>(pixel[3]) / 255;
            const float under = std::min(halo.at(x, y) * 2.2F, 1.0F) * kHaloDarkness;
            pixel[3] = static_cast<std::uint8_t>(std::lround(255 * (over + under * (1 - over))));
        }
    }
}

}  // namespace quadrat::render
