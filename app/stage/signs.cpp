// SPDX-License-Identifier: Apache-2.0
#include "stage/signs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/code_picture.hpp"
#include "stage/easel.hpp"
#include "stage/marks.hpp"

namespace quadrat::stage {
namespace {

constexpr glm::vec4 rgb(int r, int g, int b) {
    return {static_cast<float>(r) / 255.0F, static_cast<float>(g) / 255.0F, static_cast<float>(b) / 255.0F, 1.0F};
}

const std::array<Quarter, kQuarters> kQuarterTable{{
    {"A", render::Shape::Circle, rgb(0, 80, 145)},      // blue
    {"B", render::Shape::Triangle, rgb(250, 205, 70)},  // light orange
    {"C", render::Shape::Square, rgb(0, 134, 96)},      // bluish green
    {"D", render::Shape::Diamond, rgb(220, 140, 186)},  // light reddish purple
}};

// Prompts change by visit, not by frame; what is kept is far below this unless sizes change.
constexpr std::size_t kWrittenKept = 96;

render::TextStyle style_of(float size_px, bool is_bold, int max_width_px) {
    render::TextStyle style;
    style.size_px = size_px;
    style.is_bold = is_bold;
    style.max_width_px = max_width_px;
    style.shadow_px = std::max(2.0F, size_px * 0.12F);
    return style;
}

constexpr float kBesideOfEm = 1.3F;  // a pictogram's side beside words, and without them
constexpr float kAloneOfEm = 2.2F;
constexpr float kGapOfEm = 0.05F;  // words have a margin of their own

std::string letters_of(std::span<const render::Pictogram> row) {
    std::string letters;
    for (const render::Pictogram which : row) letters += static_cast<char>('a' + static_cast<int>(which));
    return letters + ' ';
}

// As it is, in the middle of the other's height.
void put(const mesh::Image& image, mesh::Image& onto, int left) {
    const int top = (onto.height - image.height) / 2;
    for (int y = 0; y < image.height; ++y)
        std::copy_n(image.pixel(0, y), 4 * static_cast<std::size_t>(image.width), onto.pixel(left, top + y));
}

mesh::Image drawn(std::span<const render::Pictogram> row, int size_px, SignWriter::Begins begins) {
    const auto count = static_cast<int>(row.size());
    mesh::Image all(count * size_px, size_px, 4);
    for (int i = 0; i < count; ++i) {
        const mesh::Image one = render::pictogram(row[static_cast<std::size_t>(i)], size_px);
        const int place = begins == SignWriter::Begins::Right ? count - 1 - i : i;
        if (one.height == size_px) put(one, all, place * size_px);  // no smaller than a pictogram can be
    }
    return all;
}

}  // namespace

const Quarter& quarter(std::size_t index) { return kQuarterTable.at(index); }

SignWriter::Written SignWriter::keep(const Key& key, const mesh::Image& image) {
    if (written_.size() >= kWrittenKept) written_.clear();
    Written written{renderer_.texture(image), image.width, image.height};
    written_.emplace(key, written);
    return written;
}

SignWriter::Written SignWriter::text(const std::string& utf8, float size_px, bool is_bold, int max_width_px) {
    const Key key{utf8, static_cast<int>(std::lround(size_px)), is_bold, max_width_px};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    return keep(key, render::letter(utf8, style_of(size_px, is_bold, max_width_px)));
}

SignWriter::Written SignWriter::badge(std::size_t quarter_index, int size_px) {
    const Key key{std::string("\x01") + quarter(quarter_index).letter, size_px, true, 0};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    const Quarter& q = quarter(quarter_index);
    return keep(key, render::badge(q.shape, q.letter, q.colour, size_px));
}

SignWriter::Written SignWriter::pictogram(render::Pictogram which, int size_px) {
    const Key key{{'\x03', static_cast<char>('a' + static_cast<int>(which))}, size_px, false, 0};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    return keep(key, render::pictogram(which, size_px));
}

SignWriter::Written SignWriter::pictograms(std::span<const render::Pictogram> row, int size_px, Begins begins) {
    if (row.empty()) return {};
    if (row.size() == 1) return pictogram(row.front(), size_px);
    const Key key{fmt::format("\x04{}{}", letters_of(row), begins == Begins::Right ? '<' : '>'), size_px, false, 0};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    return keep(key, drawn(row, size_px, begins));
}

SignWriter::Written SignWriter::code(const std::string& text, int most_px) {
    const Key key{std::string("\x02") + text, most_px, false, 0};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    const mesh::Image image = render::code_picture(text, most_px);
    return image.width > 0 ? keep(key, image) : Written{};
}

std::shared_ptr<const render::Texture> SignWriter::picture(const mesh::Image& image) {
    if (pictured_ != &image) picture_ = renderer_.texture(image);
    pictured_ = &image;
    return picture_;
}

float SignWriter::fitted_px(const std::string& utf8, float size_px, bool is_bold, glm::ivec2 most_px) {
    constexpr float kStep = 0.94F;
    constexpr float kSmallest_px = 6;
    const std::tuple<std::string, int, bool, int, int> key{utf8, static_cast<int>(std::lround(size_px)), is_bold,
                                                           most_px.x, most_px.y};
    if (fitted_.size() >= kWrittenKept) fitted_.clear();
    auto [fitted, is_new] = fitted_.try_emplace(key, size_px);
    while (is_new && fitted->second > kSmallest_px &&
           render::letter(utf8, style_of(fitted->second, is_bold, most_px.x)).height > most_px.y)
        fitted->second *= kStep;
    if (const float share = fitted->second / size_px; share < tightest_.share) tightest_ = {share, utf8};
    return fitted->second;
}

SignWriter::Written SignWriter::text_within(const std::string& utf8, float size_px, bool is_bold, glm::ivec2 most_px) {
    return text(utf8, fitted_px(utf8, size_px, is_bold, most_px), is_bold, most_px.x);
}

SignWriter::Written SignWriter::said_within(std::span<const render::Pictogram> row, const std::string& utf8,
                                            float size_px, bool is_bold, glm::ivec2 most_px, Begins begins) {
    if (row.empty()) return text_within(utf8, size_px, is_bold, most_px);
    const float wished = (utf8.empty() ? kAloneOfEm : kBesideOfEm) * size_px;
    const auto count = static_cast<int>(row.size());
    // On a picture of a few pixels there is no room at all.
    const int side = std::max(1, std::min({static_cast<int>(std::lround(wished)), most_px.y, most_px.x / count}));
    if (utf8.empty()) return pictograms(row, side, begins);
    const Key key{fmt::format("\x05{}{}{}", letters_of(row), begins == Begins::Right ? '<' : '>', utf8),
                  static_cast<int>(std::lround(size_px)), is_bold, most_px.x << 16 | most_px.y};
    if (const auto found = written_.find(key); found != written_.end()) return found->second;
    const int gap = static_cast<int>(kGapOfEm * size_px);
    const glm::ivec2 room{std::max(1, most_px.x - count * side - gap), most_px.y};
    const float fitted = fitted_px(utf8, size_px, is_bold, room);
    const mesh::Image words = render::letter(utf8, style_of(fitted, is_bold, room.x));
    mesh::Image all(count * side + gap + words.width, std::max(side, words.height), 4);
    const bool is_mirrored = begins == Begins::Right;
    put(drawn(row, side, begins), all, is_mirrored ? words.width + gap : 0);
    put(words, all, is_mirrored ? 0 : count * side + gap);
    return keep(key, all);
}

SignWriter::Written SignWriter::line_within(const std::string& utf8, float size_px, bool is_bold, int most_px) {
    Written whole = text(utf8, size_px, is_bold);
    if (whole.width <= most_px) return whole;
    constexpr float kSurely = 0.97F;  // letters are hinted, so that widths are not quite in proportion
    return text(utf8, kSurely * size_px * static_cast<float>(std::max(1, most_px)) / static_cast<float>(whole.width),
                is_bold);
}

std::vector<render::Sign> SignWriter::badges(int width, int height, TextSize text_size,
                                             std::optional<std::size_t> marked) {
    const auto places = quarters(width, height);
    const int usual = badge_px(text_size, height);
    const int usual_inset = std::max(6, height / 60);
    const int marked_inset = usual_inset + mark_reach_px(height);
    std::vector<render::Sign> signs;
    for (std::size_t i = 0; i < kQuarters; ++i) {
        const render::Rect& q = places[i];
        const int size = marked == i ? usual * 3 / 2 : usual;
        const int inset = marked == i ? marked_inset : usual_inset;
        const bool is_left = i % 2 == 0;
        const bool is_top = i < 2;
        render::Sign sign;
        sign.texture = badge(i, size).texture;
        sign.place = {is_left ? q.x + inset : q.x + q.width - inset - size,
                      is_top ? q.y + q.height - inset - size : q.y + inset, size, size};
        signs.push_back(std::move(sign));
    }
    return signs;
}

}  // namespace quadrat::stage
