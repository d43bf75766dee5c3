// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "pictures/paste.hpp"
#include "pictures/picture.hpp"
#include "render/lettering.hpp"

namespace quadrat::pictures {
namespace {

constexpr int kMarginPx = 16;
constexpr int kCaptionPx = 34;
constexpr std::uint8_t kPaper = 28;

// Averages the source pixels that fall on each target pixel: sheets are always smaller than their pictures.
void put_scaled(const mesh::Image& source, mesh::Image& target, int left, int top, int width, int height) {
    for (int y = 0; y < height; ++y) {
        const int y0 = y * source.height / height;
        const int y1 = std::max(y0 + 1, (y + 1) * source.height / height);
        for (int x = 0; x < width; ++x) {
            const int x0 = x * source.width / width;
            const int x1 = std::max(x0 + 1, (x + 1) * source.width / width);
            int sum[3] = {0, 0, 0};
            for (int sy = y0; sy < y1; ++sy)
                for (int sx = x0; sx < x1; ++sx)
                    for (int c = 0; c < 3; ++c) sum[c] += source.pixel(sx, sy)[c];
            const int count = (y1 - y0) * (x1 - x0);
            for (int c = 0; c < 3; ++c) target.pixel(left + x, top + y)[c] = static_cast<std::uint8_t>(sum[c] / count);
        }
    }
}

}  // namespace

mesh::Image scaled_to(const mesh::Image& pixels, int width_px) {
    const int width = std::clamp(width_px, 1, std::max(1, pixels.width));
    mesh::Image small(width, std::max(1, width * pixels.height / std::max(1, pixels.width)), 4);
    put_scaled(pixels, small, 0, 0, small.width, small.height);
    for (std::size_t i = 3; i < small.bytes.size(); i += 4) small.bytes[i] = 255;
    return small;
}

mesh::Image contact_sheet(const std::vector<SheetEntry>& entries, int columns, int entry_width_px) {
    if (entries.empty() || columns < 1) return {};
    const mesh::Image& first = entries.front().pixels;
    const int height_px = std::max(1, entry_width_px * first.height / std::max(1, first.width));
    const int rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
    const int cell_w = entry_width_px + kMarginPx;
    const int cell_h = height_px + kCaptionPx + kMarginPx;
    mesh::Image sheet(columns * cell_w + kMarginPx, rows * cell_h + kMarginPx, 4);
    for (std::size_t i = 0; i < sheet.bytes.size(); ++i) sheet.bytes[i] = i % 4 == 3 ? 255 : kPaper;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const int left = kMarginPx + static_cast<int>(i) % columns * cell_w;
        const int top = kMarginPx + static_cast<int>(i) / columns * cell_h;
        put_scaled(entries[i].pixels, sheet, left, top, entry_width_px, height_px);
        if (entries[i].caption.empty()) continue;
        render::TextStyle style;
        style.size_px = 18;
        style.shadow_px = 0;
        paste(render::letter(entries[i].caption, style), sheet, left, top + height_px + 6);
    }
    return sheet;
}

}  // namespace quadrat::pictures
