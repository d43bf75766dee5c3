// SPDX-License-Identifier: Apache-2.0
#include "pictures/png_picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "base/file.hpp"

namespace quadrat::pictures {
namespace {

struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

using Surface = std::unique_ptr<cairo_surface_t, Destroy>;

constexpr int kLargestSide = 4096;

void require_success(cairo_status_t status, const std::filesystem::path& path) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw base::InputError(fmt::format("{}: {}", path.string(), cairo_status_to_string(status)));
}

}  // namespace

mesh::Image read_png_quickly(const std::filesystem::path& path) {
    const Surface png(cairo_image_surface_create_from_png(path.c_str()));
    require_success(cairo_surface_status(png.get()), path);
    const auto format = cairo_image_surface_get_format(png.get());
    mesh::Image image(cairo_image_surface_get_width(png.get()), cairo_image_surface_get_height(png.get()), 4);
    const bool is_usual = format == CAIRO_FORMAT_ARGB32 || format == CAIRO_FORMAT_RGB24;
    if (!is_usual || image.width > kLargestSide || image.height > kLargestSide)
        throw base::InputError(fmt::format("{}: not a picture of eight bits a colour", path.string()));
    const unsigned char* const rows = cairo_image_surface_get_data(png.get());
    const int stride = cairo_image_surface_get_stride(png.get());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t word = 0;
            std::memcpy(&word, rows + y * stride + x * 4, sizeof word);
            std::uint8_t* const to = image.pixel(x, y);
            to[0] = static_cast<std::uint8_t>(word >> 16U);
            to[1] = static_cast<std::uint8_t>(word >> 8U);
            to[2] = static_cast<std::uint8_t>(word);
            to[3] = 255;
        }
    return image;
}

void write_png_quickly(const std::filesystem::path& path, const mesh::Image& image) {
    const Surface png(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
    require_success(cairo_surface_status(png.get()), path);
    unsigned char* const rows = cairo_image_surface_get_data(png.get());
    const int stride = cairo_image_surface_get_stride(png.get());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* const from = image.pixel(x, y);
            const std::uint32_t word = std::uint32_t{from[0]} << 16U | std::uint32_t{from[1]} << 8U | from[2];
            std::memcpy(rows + y * stride + x * 4, &word, sizeof word);
        }
    cairo_surface_mark_dirty(png.get());
    std::string bytes;
    const auto append = [](void* to, const unsigned char* from, unsigned count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(from), count);
        return CAIRO_STATUS_SUCCESS;
    };
    require_success(cairo_surface_write_to_png_stream(png.get(), append, &bytes), path);
    base::write_file(path, bytes);
}

}  // namespace quadrat::pictures
