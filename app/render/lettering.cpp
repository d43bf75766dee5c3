// SPDX-License-Identifier: Apache-2.0
#include "render/lettering.hpp"

#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "render/cairo_drawing.hpp"
#include "scene/colour.hpp"

namespace quadrat::render {
namespace {

struct FreePango {
    void operator()(PangoLayout* l) const { g_object_unref(l); }
    void operator()(PangoFontDescription* d) const { pango_font_description_free(d); }
};
using Layout = std::unique_ptr<PangoLayout, FreePango>;
using Font = std::unique_ptr<PangoFontDescription, FreePango>;

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
