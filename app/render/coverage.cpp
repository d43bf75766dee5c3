// SPDX-License-Identifier: Apache-2.0
#include "render/coverage.hpp"

#include <pango/pangocairo.h>

#include <memory>

#include "render/lettering.hpp"

namespace quadrat::render {
namespace {

struct Free {
    void operator()(PangoContext* c) const { g_object_unref(c); }
    void operator()(PangoLayout* l) const { g_object_unref(l); }
    void operator()(PangoFontDescription* d) const { pango_font_description_free(d); }
    void operator()(PangoLayoutIter* i) const { pango_layout_iter_free(i); }
};

void append(std::string& letters, gunichar letter) {
    char bytes[6];
    const std::string one(bytes, static_cast<std::size_t>(g_unichar_to_utf8(letter, bytes)));
    if (letters.find(one) == std::string::npos) letters += one;
}

}  // namespace

std::string letters_without_font(const std::string& utf8) {
    // As render::letter shapes it.
    const std::unique_ptr<PangoContext, Free> context{
        pango_font_map_create_context(pango_cairo_font_map_get_default())};
    const std::unique_ptr<PangoLayout, Free> layout{pango_layout_new(context.get())};
    const std::unique_ptr<PangoFontDescription, Free> font{
        pango_font_description_from_string(TextStyle{}.typeface.c_str())};
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_text(layout.get(), utf8.data(), static_cast<int>(utf8.size()));
    std::string letters;
    if (pango_layout_get_unknown_glyphs_count(layout.get()) == 0) return letters;
    const std::unique_ptr<PangoLayoutIter, Free> at{pango_layout_get_iter(layout.get())};
    do {
        const PangoLayoutRun* run = pango_layout_iter_get_run_readonly(at.get());
        for (int i = 0; run != nullptr && i < run->glyphs->num_glyphs; ++i) {
            const PangoGlyph glyph = run->glyphs->glyphs[i].glyph;
            if ((glyph & PANGO_GLYPH_UNKNOWN_FLAG) != 0 && glyph != PANGO_GLYPH_INVALID_INPUT)
                append(letters, glyph & ~static_cast<PangoGlyph>(PANGO_GLYPH_UNKNOWN_FLAG));
        }
    } while (pango_layout_iter_next_run(at.get()));
    return letters;
}

}  // namespace quadrat::render
