// SPDX-License-Identifier: Apache-2.0
#include "pictures/postcard.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <vector>

#include "pictures/paste.hpp"
#include "render/code_picture.hpp"
#include "render/lettering.hpp"

namespace quadrat::pictures {
namespace {

constexpr int kMargin_px = (kPostcard_px.x - kOnPostcard_px.x) / 2;
constexpr int kGap_px = 36;
constexpr int kBand_px = kPostcard_px.y - kOnPostcard_px.y - 2 * kMargin_px - kGap_px;  // for letters and the code
constexpr float kTitle_px = 60;
constexpr float kSmallestTitle_px = 20;
constexpr float kBelow_px = 34;
constexpr float kInk = 0.13F;
constexpr float kPaleInk = 0.40F;

mesh::Image written(const std::string& text, float size_px, float ink) {
    render::TextStyle style;
    style.size_px = size_px;
    style.colour = {ink, ink, ink, 1};
    style.shadow_px = 0;
    return render::letter(text, style);
}

// Its phrases, each on a line of its own: "steep land; sparse trees; a red sky", and as Arabic writes it.
std::vector<std::string> phrases_of(const std::string& title) {
    std::vector<std::string> phrases;
    for (std::size_t begin = 0; begin < title.size();) {
        std::size_t end = title.size();
        std::size_t next = end;
        for (const std::string_view mark : {"; ", "؛ ", "；"})
            if (const std::size_t at = title.find(mark, begin); at < end) {
                end = at;
                next = at + mark.size();
            }
        phrases.push_back(title.substr(begin, end - begin));
        begin = next;
    }
    return phrases;
}

// As large as the widest and all together fit.
std::vector<mesh::Image> lines_within(const std::vector<std::string>& phrases, int width_px, int height_px) {
    std::vector<mesh::Image> lines;
    for (float size_px = kTitle_px;; size_px *= 0.94F) {
        lines.clear();
        int high_px = 0;
        int wide_px = 0;
        for (const std::string& phrase : phrases) {
            lines.push_back(written(phrase, size_px, kInk));
            high_px += lines.back().height;
            wide_px = std::max(wide_px, lines.back().width);
        }
        if ((wide_px <= width_px && high_px <= height_px) || size_px < kSmallestTitle_px) return lines;
    }
}

}  // namespace

mesh::Image filling_postcard(const mesh::Image& picture) {
    if (picture.width == kOnPostcard_px.x && picture.height == kOnPostcard_px.y) return picture;
    const float step = std::min(static_cast<float>(picture.width) / static_cast<float>(kOnPostcard_px.x),
                                static_cast<float>(picture.height) / static_cast<float>(kOnPostcard_px.y));
    const float left = (static_cast<float>(picture.width) - step * static_cast<float>(kOnPostcard_px.x)) / 2;
    const float top = (static_cast<float>(picture.height) - step * static_cast<float>(kOnPostcard_px.y)) / 2;
    const auto at = [](float begin, float by, int i, int most, float& share) {
        const float where =
            std::clamp(begin + (static_cast<float>(i) + 0.5F) * by - 0.5F, 0.0F, static_cast<float>(most));
        const int whole = std::min(static_cast<int>(where), most);
        share = where - static_cast<float>(whole);
        return whole;
    };
    mesh::Image filled(kOnPostcard_px.x, kOnPostcard_px.y, 4);
    for (int y = 0; y < filled.height; ++y)
        for (int x = 0; x < filled.width; ++x) {
            float right_share = 0, lower_share = 0;
            const int from_x = at(left, step, x, picture.width - 1, right_share);
            const int from_y = at(top, step, y, picture.height - 1, lower_share);
            const int next_x = std::min(from_x + 1, picture.width - 1),
                      next_y = std::min(from_y + 1, picture.height - 1);
            for (int c = 0; c < 3; ++c) {
                const auto of = [&](int px, int py) { return static_cast<float>(picture.pixel(px, py)[c]); };
                const float upper = of(from_x, from_y) * (1 - right_share) + of(next_x, from_y) * right_share;
                const float lower = of(from_x, next_y) * (1 - right_share) + of(next_x, next_y) * right_share;
                filled.pixel(x, y)[c] =
                    static_cast<std::uint8_t>(upper * (1 - lower_share) + lower * lower_share + 0.5F);
            }
            filled.pixel(x, y)[3] = 255;
        }
    return filled;
}

mesh::Image draw_postcard(const Postcard& card) {
    assert(card.landscape.width == kOnPostcard_px.x && card.landscape.height == kOnPostcard_px.y);
    mesh::Image paper(kPostcard_px.x, kPostcard_px.y, 4);
    std::ranges::fill(paper.bytes, std::uint8_t{255});
    paste(card.landscape, paper, kMargin_px, kMargin_px);
    const int top = kMargin_px + kOnPostcard_px.y + kGap_px;
    const int right = kPostcard_px.x - kMargin_px;
    const auto put = [&](const mesh::Image& image, int y, bool is_at_start) {
        const bool is_left = is_at_start != card.reads_right_to_left;
        paste(image, paper, is_left ? kMargin_px : right - image.width, y);
    };
    const mesh::Image code = card.code.empty() ? mesh::Image() : render::code_picture(card.code, kBand_px);
    const int room_px = kOnPostcard_px.x - (code.width > 0 ? code.width + kGap_px : 0);
    if (code.width > 0) put(code, top, false);
    const mesh::Image below = card.below.empty() ? mesh::Image() : written(card.below, kBelow_px, kPaleInk);
    int at = top;
    for (const mesh::Image& line : lines_within(phrases_of(card.title), room_px, kBand_px - below.height - kGap_px)) {
        put(line, at, true);
        at += line.height;
    }
    if (below.height > 0) put(below, top + kBand_px - below.height, true);
    return paper;
}

}  // namespace quadrat::pictures
