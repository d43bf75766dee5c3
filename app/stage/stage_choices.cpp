// SPDX-License-Identifier: Apache-2.0
// What the four buttons mean beside one landscape: a label each, placed as the quarters are; and the slider they turn.
#include <algorithm>

#include "stage/marks.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {
namespace {

constexpr glm::vec4 kGroove{1, 1, 1, 0.4F};
constexpr glm::vec4 kKnob{1, 1, 1, 1};

}  // namespace

int Stage::labels_top(int height) const {
    const int badge = badge_px(look_of(configuration_.look).size, height);
    const int inset = height / 24;
    const int pad = std::max(4, height / 90);
    return inset + 2 * (badge + 2 * pad) + std::max(inset / 2, mark_reach_px(height) + pad / 4) + mark_reach_px(height);
}

int Stage::lower_row(int height) const {
    return badge_px(look_of(configuration_.look).size, height) + 2 * std::max(4, height / 90);
}

int Stage::beside_arrows(int height) {
    const Look look = look_of(configuration_.look);
    const int arrow = writer_.text("↕", em_px(Letters::Label, look.size, height), true).width;
    const int widest = std::max(arrow, writer_.text("←", em_px(Letters::Label, look.size, height), true).width);
    return height / 24 + badge_px(look.size, height) + widest + 3 * std::max(4, height / 90) + mark_reach_px(height);
}

void Stage::add_labels(render::Frame& frame, const StageView& view) {
    const glm::ivec2 size = frame.size;
    const Look look = look_of(configuration_.look);
    const float em = em_px(Letters::Label, look.size, size.y);
    const int badge = badge_px(look.size, size.y);
    const int pad = std::max(4, size.y / 90);
    const int inset = size.y / 24;
    const int gap = std::max(inset / 2, mark_reach_px(size.y) + pad / 4);  // a mark has room in it
    std::array<SignWriter::Written, kQuarters> labels;
    int height = badge;
    int widest = 0;
    for (std::size_t i = 0; i < kQuarters; ++i) {
        labels[i] = written(view, view.asked->keys[i], view.asked->labels[i],
                            {em, true, {size.x / 2 - 2 * inset - badge - 3 * pad, badge}});
        height = std::max(height, labels[i].height);
        widest = std::max(widest, badge + labels[i].width + 3 * pad);
    }
    height += 2 * pad;
    for (std::size_t i = 0; i < kQuarters; ++i) {
        if (view.asked->labels[i].empty()) continue;  // the button stands for nothing
        const SignWriter::Written& written = labels[i];
        const int width = badge + written.width + 3 * pad;
        const bool is_left = i % 2 == 0;
        const bool is_upper = i < 2;
        render::Sign plate;
        plate.place = {is_left ? inset : size.x - inset - width, inset + (is_upper ? height + gap : 0), width, height};
        plate.corner_radius_px = em * 0.5F;
        add_ground(frame, plate.place, plate.corner_radius_px);
        if (view.flash && static_cast<std::size_t>(view.flash->button) == i && flash_left(view) > 0) {
            plate.colour = glm::vec4(glm::vec3(quarter(i).colour), flash_left(view));
            plate.border_px = std::max(2.0F, em * 0.12F);
            frame.signs.push_back(plate);
        }
        render::Sign sign;
        sign.texture = writer_.badge(i, badge).texture;
        sign.place = {plate.place.x + pad, plate.place.y + (height - badge) / 2, badge, badge};
        frame.signs.push_back(sign);
        sign.texture = written.texture;
        sign.place = {plate.place.x + badge + 2 * pad, plate.place.y + (height - written.height) / 2, written.width,
                      written.height};
        frame.signs.push_back(sign);
        if (view.scanned != nullptr && view.scanned->marked == static_cast<exhibit::Choice>(i))
            add_mark(frame, around(frame, plate.place), glm::vec3(quarter(i).colour), Corners::Plain,
                     em * 0.5F + static_cast<float>(mark_reach_px(size.y)));
    }
    if (view.asked->slider) add_slider(frame, *view.asked->slider, size.x - 2 * (inset + widest + gap));
}

// In the middle of the screen's lower part, between the labels: low end, groove and knob, high end.
void Stage::add_slider(render::Frame& frame, const ShownSlider& slider, int room_px) {
    const glm::ivec2 size = frame.size;
    const float em = em_px(Letters::Question, look_of(configuration_.look).size, size.y);
    const int pad = std::max(4, static_cast<int>(em * 0.6F));
    const int groove = size.x / 5;
    const int most = (room_px - groove - 4 * pad) / 2;
    const auto low = writer_.line_within(slider.low, em, true, most);
    const auto high = writer_.line_within(slider.high, em, true, most);
    const int height = std::max(low.height, high.height) + pad;
    const int width = low.width + groove + high.width + 4 * pad;
    const render::Rect plate{(size.x - width) / 2, size.y * 3 / 10 - height / 2, width, height};
    add_ground(frame, plate, em * 0.5F);
    const int bar = std::max(3, static_cast<int>(em / 5));
    const int left = plate.x + pad + low.width + pad;
    const auto add = [&](const render::Rect& place, const glm::vec4& colour) {
        render::Sign part;
        part.place = place;
        part.colour = colour;
        part.corner_radius_px = static_cast<float>(std::min(place.width, place.height)) / 2;
        frame.signs.push_back(part);
    };
    add({left, plate.y + (height - bar) / 2, groove, bar}, kGroove);
    const int knob = std::max(2 * bar, static_cast<int>(em * 0.8F));
    const int at = left + static_cast<int>(slider.share * static_cast<float>(groove - knob));
    add({at, plate.y + (height - knob) / 2, knob, knob}, kKnob);
    const auto write = [&](const SignWriter::Written& written, int x) {
        render::Sign words;
        words.texture = written.texture;
        words.place = {x, plate.y + (height - written.height) / 2, written.width, written.height};
        frame.signs.push_back(words);
    };
    write(low, plate.x + pad);
    write(high, left + groove + pad);
}

}  // namespace quadrat::stage
