// SPDX-License-Identifier: Apache-2.0
// The plate with the words of the moment, what stands below them, and how far things are.
#include <algorithm>
#include <array>
#include <cmath>

#include "stage/demonstration.hpp"
#include "stage/marks.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {
namespace {

using exhibit::Screen;

constexpr glm::vec4 kQuiet{1, 1, 1, 0.28F};
constexpr glm::vec4 kQuietHigh{1, 1, 1, 0.45F};
constexpr glm::vec4 kDone{1, 1, 1, 0.95F};
constexpr float kSinks = 0.07F;      // of a badge, on each side, when it is pressed
constexpr float kOthersFade = 0.5F;  // the other badges meanwhile
constexpr float kFinger = 0.36F;     // its width, of a badge
constexpr float kFingerLength = 0.7F;
constexpr int kCodeShare = 38;  // of the picture's height, in hundredths, at most
constexpr int kCodeLine = 9;    // and what stands below it

// Back has no quarter; it is white.
glm::vec3 flash_colour(exhibit::Choice button) {
    return button == exhibit::Choice::Back ? glm::vec3{1} : glm::vec3(quarter(static_cast<std::size_t>(button)).colour);
}

// What stands below the prompt, smaller; may be empty.
std::string line_below(const StageView& view, const site::Configuration& configuration) {
    if (view.scanned != nullptr && !view.scanned->hint.empty() && !view.cast.scenes.empty())
        return site::text(configuration, view.scanned->hint, view.language);
    const bool has_caption =
        view.state.screen == exhibit::Screen::Breed || view.state.screen == exhibit::Screen::Finale;
    return has_caption ? std::string(view.caption) : "";
}

// From below, its tip on the button's lower part when it presses, so that the letter stays. In calm it does not come:
// the button is ringed.
void add_finger(render::Frame& frame, const render::Rect& button, float press, const Look& look) {
    const auto side = static_cast<float>(button.width);
    render::Sign sign;
    if (look.is_calm) {
        const auto size = static_cast<int>(1.2F * side);
        sign.place = {button.x - (size - button.width) / 2, button.y - (size - button.width) / 2, size, size};
        sign.corner_radius_px = static_cast<float>(size) / 2;
        sign.border_px = side / 16;
        sign.colour = glm::vec4(1, 1, 1, press);
        frame.signs.push_back(sign);
        return;
    }
    const int width = static_cast<int>(kFinger * side);
    const int length = static_cast<int>(kFingerLength * side);
    const float tip = side * (0.3F * press - 0.06F * (1 - press));  // above the button's lower edge
    sign.place = {button.x + (button.width - width) / 2, button.y + static_cast<int>(tip) - length, width, length};
    sign.corner_radius_px = static_cast<float>(width) / 2;
    sign.colour = glm::vec4(0.97F, 0.96F, 0.94F, 0.94F);
    frame.signs.push_back(sign);
    sign.colour = glm::vec4(0.05F, 0.06F, 0.07F, 0.9F);
    sign.border_px = std::max(1.0F, side / 28);
    frame.signs.push_back(sign);
    const int nail = width * 6 / 10;
    sign.place = {sign.place.x + (width - nail) / 2, sign.place.y + length - width / 5 - nail, nail, nail};
    sign.corner_radius_px = static_cast<float>(nail) * 0.45F;
    sign.colour = glm::vec4(0.86F, 0.80F, 0.77F, 1);
    sign.border_px = 0;
    frame.signs.push_back(sign);
}

}  // namespace

void Stage::add_plate(render::Frame& frame, const StageView& view) {
    const bool is_four = shows_four(view);
    const Look look = look_of(configuration_.look);
    const bool has_labels = view.asked != nullptr;
    const float em = em_px(is_four || has_labels ? Letters::Question : Letters::Statement, look.size, frame.size.y);
    // Labels stand below it, or a code above it.
    const bool has_code = view.state.screen == Screen::Finale && !view.take_home.empty();
    const glm::ivec2 most{frame.size.x * 8 / 10, frame.size.y * (has_labels || has_code ? 18 : 30) / 100};
    const auto written = writer_.text_within(words(view, configuration_), em, true, most);
    std::optional<SignWriter::Written> caption;
    const int most_below = frame.size.y * (has_labels ? 7 : has_code ? 14 : 20) / 100;
    if (const std::string below = line_below(view, configuration_); !below.empty())
        caption = writer_.text_within(below, em_px(Letters::Below, look.size, frame.size.y), look.has_high_contrast,
                                      {frame.size.x * 7 / 10, most_below});
    const int pad = static_cast<int>(em * 0.6F);
    const int below = caption ? caption->height + pad / 4 : 0;
    const bool has_steps = is_four && view.state.screen != exhibit::Screen::StillThere;
    const int steps = has_steps ? static_cast<int>(em * 0.55F) : 0;
    const int widest = std::max(written.width, caption ? caption->width : 0);
    render::Rect plate{0, 0, widest + 2 * pad, written.height + below + pad + steps};
    plate.x = (frame.size.x - plate.width) / 2;
    plate.y = is_four                 ? (frame.size.y - plate.height) / 2
              : view.asked != nullptr ? frame.size.y - plate.height - frame.size.y / 24
                                      : frame.size.y / 16;
    add_ground(frame, plate, em * 0.5F);
    // Whatever is on the screen, a press is seen: the plate lights up in the button's colour.
    if (const float left = flash_left(view); left > 0) {
        render::Sign lit;
        lit.place = plate;
        lit.corner_radius_px = em * 0.5F;
        lit.colour = glm::vec4(flash_colour(view.flash->button), left);
        lit.border_px = std::max(2.0F, em * 0.12F);
        frame.signs.push_back(lit);
    }
    render::Sign words_sign;
    words_sign.texture = written.texture;
    words_sign.place = {plate.x + (plate.width - written.width) / 2, plate.y + pad / 2 + steps + below, written.width,
                        written.height};
    frame.signs.push_back(words_sign);
    if (caption) {
        words_sign.texture = caption->texture;
        words_sign.place = {plate.x + (plate.width - caption->width) / 2, plate.y + pad / 2 + steps, caption->width,
                            caption->height};
        frame.signs.push_back(words_sign);
    }
    if (has_steps) add_progress(frame, view, plate);
    if (view.scanned != nullptr && view.scanned->offers_back) add_back(frame, view, plate);
    if (view.state.screen == exhibit::Screen::Attract && configuration_.play.shows_how && !view.cast.scenes.empty())
        add_demonstration(frame, view, plate);
    if (has_code) add_take_home(frame, view, plate);
}

// Above the plate: a question, the four signs as the buttons bear them, and a finger that presses one.
void Stage::add_demonstration(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const auto ghost = ghost_at(view.now - view.state.since);
    if (!ghost) return;
    const Look look = look_of(configuration_.look);
    constexpr std::array kKeys{"ask.trees", "ask.land", "ask.sky"};
    const auto question = writer_.text_within(
        site::text(configuration_, kKeys[static_cast<std::size_t>(ghost->question)], view.language),
        em_px(Letters::Below, look.size, frame.size.y), true, {frame.size.x * 7 / 10, frame.size.y / 6});
    // As large as there is room for.
    int badge = badge_px(look.size, frame.size.y), pad = 0, finger = 0;
    render::Rect card;
    for (;; badge = badge * 9 / 10) {
        pad = badge / 4;
        finger = look.is_calm ? 0 : badge * 6 / 10;
        card = {0, plate.y + plate.height + pad, std::max(4 * badge + 3 * pad, question.width) + 2 * pad,
                badge + question.height + 3 * pad + finger};
        if (card.y + card.height + pad <= frame.size.y || badge < 8) break;
    }
    const int row = 4 * badge + 3 * pad;
    card.x = (frame.size.x - card.width) / 2;
    const int bottom = card.y + pad + finger;  // of the badges
    const std::size_t first = frame.signs.size();
    add_ground(frame, card, static_cast<float>(pad));
    render::Sign sign;
    sign.texture = question.texture;
    sign.place = {card.x + (card.width - question.width) / 2, card.y + card.height - pad - question.height,
                  question.width, question.height};
    frame.signs.push_back(sign);
    for (std::size_t i = 0; i < kQuarters; ++i) {
        const bool is_pressed = i == ghost->button;
        const int sunk =
            is_pressed && !look.is_calm ? static_cast<int>(kSinks * ghost->press * static_cast<float>(badge)) : 0;
        const int x = (frame.size.x - row) / 2 + static_cast<int>(i) * (badge + pad);
        sign.texture = writer_.badge(i, badge).texture;
        sign.place = {x + sunk, bottom + sunk, badge - 2 * sunk, badge - 2 * sunk};
        sign.colour = glm::vec4(1, 1, 1, is_pressed ? 1 : 1 - kOthersFade * ghost->press);
        frame.signs.push_back(sign);
        sign.colour = glm::vec4{1};
        if (is_pressed) add_finger(frame, {x, bottom, badge, badge}, ghost->press, look);
    }
    for (std::size_t i = first; i < frame.signs.size(); ++i) frame.signs[i].colour.a *= ghost->strength;
}

// Where lines end: the code, and below it what it is for. Beside the plate where there is room, else above it.
void Stage::add_take_home(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const Look look = look_of(configuration_.look);
    const int inset = frame.size.y / 24;
    const int pad = frame.size.y / 60;
    const auto write = [&](int width) {
        return writer_.text_within(site::text(configuration_, "take-home", view.language),
                                   em_px(Letters::Below, look.size, frame.size.y), true,
                                   {width, frame.size.y * kCodeLine / 100});
    };
    const int most = frame.size.y * kCodeShare / 100;
    auto code = writer_.code(std::string(view.take_home), most);
    auto written = write(most);
    const auto width_of = [&] { return std::max(code.width, written.width) + 2 * pad; };
    const bool is_beside = plate.x + plate.width + inset / 2 <= frame.size.x - inset - width_of();
    const int bottom = is_beside ? plate.y : plate.y + plate.height + inset / 2;
    const int room = frame.size.y - bottom - inset / 2 - written.height - 3 * pad;
    if (room < code.height) code = writer_.code(std::string(view.take_home), room);
    if (code.width == 0) return;
    const int left = reads_right_to_left(view, configuration_) ? inset : frame.size.x - inset - width_of();
    const render::Rect card{left, bottom, width_of(), code.height + written.height + 3 * pad};
    add_ground(frame, card, static_cast<float>(pad));
    render::Sign sign;
    sign.texture = written.texture;
    sign.place = {card.x + (card.width - written.width) / 2, card.y + pad, written.width, written.height};
    frame.signs.push_back(sign);
    sign.texture = code.texture;
    sign.place = {card.x + (card.width - code.width) / 2, card.y + card.height - pad - code.height, code.width,
                  code.height};
    frame.signs.push_back(sign);
}

// Below the question, in the same hand.
void Stage::add_back(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const float em = em_px(Letters::Label, look_of(configuration_.look).size, frame.size.y);
    const auto written = writer_.text_within(site::text(configuration_, "back", view.language), em, true,
                                             {frame.size.x * 3 / 10, frame.size.y * 8 / 100});
    const int pad = static_cast<int>(em * 0.6F);
    const int gap = mark_reach_px(frame.size.y) + frame.size.y / 180;
    render::Rect back{0, 0, written.width + 2 * pad, written.height + pad};
    back.x = (frame.size.x - back.width) / 2;
    back.y = plate.y - gap - back.height;
    add_ground(frame, back, em * 0.5F);
    render::Sign sign;
    sign.texture = written.texture;
    sign.place = {back.x + pad, back.y + pad / 2, written.width, written.height};
    frame.signs.push_back(sign);
    if (view.scanned->marked == exhibit::Choice::Back)
        add_mark(frame, around(frame, back), glm::vec3{1}, Corners::Plain,
                 em * 0.5F + static_cast<float>(mark_reach_px(frame.size.y)));
}

// Under the question: which of the three it is; while breeding, how far the next four have grown; while a button is
// held for that, how near it is to playing with fewer.
void Stage::add_progress(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const bool is_held = view.scanned != nullptr && view.scanned->hold > 0;
    const int steps = is_held ? 1 : 3;
    const int bar_h = std::max(3, plate.height / 16);
    const int bar_w = plate.width / (is_held ? 2 : 6);
    const int gap = bar_w / 4;
    const bool is_breeding = is_held || view.state.screen == exhibit::Screen::Breed;
    const float share_done = is_held ? view.scanned->hold : view.growing_progress;
    const float done = is_breeding ? share_done * static_cast<float>(steps) : static_cast<float>(view.state.question);
    const bool is_mirrored = reads_right_to_left(view, configuration_);
    const int first = plate.x + (plate.width - steps * bar_w - (steps - 1) * gap) / 2;
    for (int i = 0; i < steps; ++i) {
        const int x = first + (is_mirrored ? steps - 1 - i : i) * (bar_w + gap);
        const render::Rect place{x, plate.y + bar_h * 2, bar_w, bar_h};
        render::Sign bar;
        bar.place = place;
        bar.colour = look_of(configuration_.look).has_high_contrast ? kQuietHigh : kQuiet;
        bar.corner_radius_px = static_cast<float>(bar_h) / 2;
        frame.signs.push_back(bar);
        const float share = std::clamp(done - static_cast<float>(i), 0.0F, 1.0F);
        const bool is_current = !is_breeding && static_cast<int>(done) == i;
        bar.place.width = std::max(bar_h, static_cast<int>(static_cast<float>(bar_w) * share));
        if (is_mirrored) bar.place.x = x + bar_w - bar.place.width;
        bar.colour = kDone;
        if (share > 0) frame.signs.push_back(bar);
        if (is_current) {
            bar.place = place;
            bar.colour = {1, 1, 1, 0.6F};
            frame.signs.push_back(bar);
        }
    }
}

}  // namespace quadrat::stage
