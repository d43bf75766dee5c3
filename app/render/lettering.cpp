// SPDX-License-Identifier: Apache-2.0
#include "render/lettering.hpp"

#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "mesh/field.hpp"
#include "scene/colour.hpp"

namespace quadrat::render {
namespace {

struct FreeCairo {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
struct FreePango {
    void operator()(PangoLayout* l) const { g_object_unref(l); }
    void operator()(PangoFontDescription* d) const { pango_font_description_free(d); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeCairo>;
using Pen = std::unique_ptr<cairo_t, FreeCairo>;
using Layout = std::unique_ptr<PangoLayout, FreePango>;
using Font = std::unique_ptr<PangoFontDescription, FreePango>;

constexpr float kHaloDarkness = 0.72F;

// Cairo's premultiplied BGRA words as premultiplied RGBA bytes.
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

// Lays the image over a dark halo of its own outline. The halo is blurred, then hardened: soft outside, full beneath.
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

int halo_margin_px(float radius_px) { return radius_px > 0 ? static_cast<int>(std::ceil(2.5F * radius_px)) : 1; }

Layout new_layout(cairo_t* pen, const std::string& utf8, const TextStyle& style) {
    Layout layout{pango_cairo_create_layout(pen)};
    const Font font{pango_font_description_from_string(style.typeface.c_str())};
    pango_font_description_set_absolute_size(font.get(), static_cast<double>(style.size_px) * PANGO_SCALE);
    pango_font_description_set_weight(font.get(), style.is_bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_MEDIUM);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_text(layout.get(), utf8.data(), static_cast<int>(utf8.size()));
    pango_layout_set_alignment(layout.get(), PANGO_ALIGN_CENTER);
    if (style.max_width_px > 0) {
        pango_layout_set_width(layout.get(), style.max_width_px * PANGO_SCALE);
        pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    }
    return layout;
}

void draw_text(cairo_t* pen, PangoLayout* layout, glm::vec4 colour) {
    cairo_set_source_rgba(pen, static_cast<double>(colour.r), static_cast<double>(colour.g),
                          static_cast<double>(colour.b), static_cast<double>(colour.a));
    pango_cairo_show_layout(pen, layout);
}

struct Outline {
    double middle;
    double radius;
};

void trace_polygon(cairo_t* pen, Outline o, int corners, double first_turn, double down) {
    for (int i = 0; i < corners; ++i) {
        const double turn = first_turn + 2 * std::numbers::pi * i / corners;
        cairo_line_to(pen, o.middle + o.radius * std::cos(turn), o.middle + down + o.radius * std::sin(turn));
    }
    cairo_close_path(pen);
}

// Radii are chosen so that the four cover about the same area.
void trace(cairo_t* pen, Shape shape, Outline o) {
    const double up = -std::numbers::pi / 2;
    cairo_new_path(pen);
    switch (shape) {
        case Shape::Circle:
            cairo_arc(pen, o.middle, o.middle, o.radius * 0.88, 0, 2 * std::numbers::pi);
            break;
        case Shape::Triangle:
            trace_polygon(pen, {o.middle, o.radius * 1.12}, 3, up, o.radius * 0.18);
            break;
        case Shape::Square:
            trace_polygon(pen, {o.middle, o.radius * 1.08}, 4, up + std::numbers::pi / 4, 0);
            break;
        case Shape::Diamond:
            trace_polygon(pen, {o.middle, o.radius}, 4, up, 0);
            break;
    }
}

}  // namespace

mesh::Image letter(const std::string& utf8, const TextStyle& style) {
    if (utf8.empty()) return mesh::Image(1, 1, 4);
    const Surface scratch = new_surface(1, 1);
    const Pen measuring{cairo_create(scratch.get())};
    const Layout measured = new_layout(measuring.get(), utf8, style);
    PangoRectangle ink;
    PangoRectangle logical;
    pango_layout_get_pixel_extents(measured.get(), &ink, &logical);
    const int left = std::min(ink.x, logical.x);
    const int top = std::min(ink.y, logical.y);
    const int right = std::max(ink.x + ink.width, logical.x + logical.width);
    const int bottom = std::max(ink.y + ink.height, logical.y + logical.height);
    const int margin = halo_margin_px(style.shadow_px);

    const Surface surface = new_surface(right - left + 2 * margin, bottom - top + 2 * margin);
    const Pen pen{cairo_create(surface.get())};
    cairo_move_to(pen.get(), margin - left, margin - top);
    const Layout layout = new_layout(pen.get(), utf8, style);
    draw_text(pen.get(), layout.get(), style.colour);
    mesh::Image image = image_of(surface.get());
    if (style.shadow_px > 0) put_halo_under(image, style.shadow_px);
    return image;
}

mesh::Image badge(Shape shape, const std::string& letter_in_it, glm::vec4 colour, int size_px) {
    const int size = std::max(size_px, 8);
    const float halo_px = 0.045F * static_cast<float>(size);
    const Surface surface = new_surface(size, size);
    const Pen pen{cairo_create(surface.get())};
    const double line = 0.05 * size;
    const Outline outline{0.5 * size, 0.5 * size - 2.2 * static_cast<double>(halo_px) - line / 2};
    cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
    trace(pen.get(), shape, outline);
    cairo_set_source_rgba(pen.get(), static_cast<double>(colour.r), static_cast<double>(colour.g),
                          static_cast<double>(colour.b), static_cast<double>(colour.a));
    cairo_fill_preserve(pen.get());
    cairo_set_source_rgb(pen.get(), 1, 1, 1);
    cairo_set_line_width(pen.get(), line);
    cairo_stroke(pen.get());

    TextStyle style;
    style.is_bold = true;
    style.size_px = static_cast<float>(size) * (shape == Shape::Triangle ? kSmallestLetterOfBadge : 0.46F);
    const Layout layout = new_layout(pen.get(), letter_in_it, style);
    PangoRectangle ink;
    pango_layout_get_pixel_extents(layout.get(), &ink, nullptr);
    const double down = shape == Shape::Triangle ? 0.10 * size : 0;
    cairo_move_to(pen.get(), outline.middle - ink.x - 0.5 * ink.width,
                  outline.middle + down - ink.y - 0.5 * ink.height);
    // On light grounds a dark letter reads better (relative luminance, sRGB coefficients).
    const bool is_light = scene::luminance(glm::vec3(colour)) > 0.62F;
    draw_text(pen.get(), layout.get(), is_light ? glm::vec4{0.08F, 0.08F, 0.1F, 1} : glm::vec4{1});
    mesh::Image image = image_of(surface.get());
    put_halo_under(image, halo_px);
    return image;
}

}  // namespace quadrat::render
