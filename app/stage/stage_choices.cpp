// SPDX-License-Identifier: Apache-2.0
// What the four buttons mean beside one landscape: a label each, placed as the quarters are; and the slider they turn.
#include <algorithm>

#include "stage/stage.hpp"

namespace quadrat::stage {
namespace {

constexpr glm::vec4 kGroove{1, 1, 1, 0.4F};
constexpr glm::vec4 kKnob{1, 1, 1, 1};

}  // namespace

void Stage::add_labels(render::Frame& frame, const StageView& view) {
    const glm::ivec2 size = frame.size;
    const float em = static_cast<float>(size.y) / 26.0F;
    const int badge = std::max(20, size.y / 13);
    const int pad = std::max(4, size.y / 90);
    const int inset = size.y / 24;
    std::array<SignWriter::Written, kQuarters> labels;
    int height = badge;
    for (std::size_t i = 0; i < kQuarters; ++i) {
        labels[i] = writer_.text(view.asked->labels[i], em, true, size.x / 2 - 2 * inset - badge - 3 * pad);
        height = std::max(height, labels[i].height);
    }
    height += 2 * pad;
    for (std::size_t i = 0; i < kQuarters; ++i) {
        const SignWriter::Written& written = labels[i];
        const int width = badge + written.width + 3 * pad;
        const bool is_left = i % 2 == 0;
        const bool is_upper = i < 2;
        render::Sign plate;
        plate.place = {is_left ? inset : size.x - inset - width, inset + (is_upper ? height + inset / 2 : 0), width,
                       height};
        plate.colour = kPlate;
        plate.corner_radius_px = em * 0.5F;
        frame.signs.push_back(plate);
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
    }
}

// In the middle of the screen's lower part, between the labels: low end, groove and knob, high end.
void Stage::add_slider(render::Frame& frame, const ShownSlider& slider) {
    const glm::ivec2 size = frame.size;
    const float em = static_cast<float>(size.y) / 22.0F;
    const int pad = std::max(4, static_cast<int>(em * 0.6F));
    const int groove = size.x / 4;
    const auto low = writer_.text(slider.low, em, true, size.x / 4);
    const auto high = writer_.text(slider.high, em, true, size.x / 4);
    const int height = std::max(low.height, high.height) + pad;
    const int width = low.width + groove + high.width + 4 * pad;
    render::Sign sign;
    sign.place = {(size.x - width) / 2, size.y * 3 / 10, width, height};
    sign.colour = kPlate;
    sign.corner_radius_px = em * 0.5F;
    const render::Rect plate = sign.place;
    frame.signs.push_back(sign);
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
