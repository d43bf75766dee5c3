// SPDX-License-Identifier: Apache-2.0
// The plate with the words of the moment, what stands below them, and how far things are.
#include <algorithm>
#include <array>
#include <cmath>

#include "stage/demonstration.hpp"
#include "stage/easel.hpp"
#include "stage/marks.hpp"
#include "stage/pictograms.hpp"
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
constexpr int kCodeShare = 38;                      // of the picture's height, in hundredths, at most
constexpr float kCodeLines = 2.6F;                  // and what stands below it, in ems of it
constexpr float kLargeCodeLines = 3.9F;             // where its words are large
constexpr int kBesideCode = 60;                     // the plate's share of the width, where the code is beside it
constexpr float kBeside = 1.5F;                     // a pictogram's side beside the words, in ems of theirs
constexpr float kAlone = 3.0F;                      // and in place of them
constexpr std::chrono::milliseconds kTravels{900};  // what was chosen, from its quarter to the middle

// Back has no quarter; it is white.
glm::vec3 flash_colour(exhibit::Choice button) {
    return button == exhibit::Choice::Back ? glm::vec3{1} : glm::vec3(quarter(static_cast<std::size_t>(button)).colour);
}

float smooth_step(base::Instant since) {
    const float t =
        std::clamp(std::chrono::duration<float>(since) / std::chrono::duration<float>(kTravels), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

// What stands below the prompt, smaller; may be empty.
struct Below {
    std::string key;  // of genome::kPrompts; "": of none
    std::string words;
};
Below line_below(const StageView& view, const site::Configuration& configuration) {
    const auto prompt = [&](const std::string& key) {
        return Below{key, site::text(configuration, key, view.language)};
    };
    if (view.scanned != nullptr && !view.scanned->hint.empty() && !view.cast.scenes.empty())
        return prompt(view.scanned->hint);
    if (view.state.screen == Screen::Ask && view.state.rounds == 0 && exhibit::takes_turns(view.state, view.timings))
        return prompt("turns");
    const bool has_caption = view.state.screen == Screen::Breed || view.state.screen == Screen::Finale ||
                             view.state.screen == Screen::Family;
    return {"", has_caption ? std::string(view.caption) : ""};
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

// With its pictograms where the site wants them, or by them alone.
SignWriter::Written Stage::written(const StageView& view, std::string_view key, const std::string& utf8,
                                   const Room& room) {
    const std::string& pictograms = configuration_.look.pictograms;
    const auto row = pictograms == "none" ? std::span<const render::Pictogram>{} : pictograms_for(key);
    const bool is_alone = pictograms == "alone" && !row.empty();
    return writer_.said_within(row, is_alone ? "" : utf8, room.em_px, room.is_bold, room.most_px, begins(view));
}

SignWriter::Begins Stage::begins(const StageView& view) const {
    return reads_right_to_left(view, configuration_) ? SignWriter::Begins::Right : SignWriter::Begins::Left;
}

// Where the finale asks, labels fill the lower half as soon as they are large: the code lies beside the plate then.
bool Stage::shares_top(const StageView& view) const {
    return view.asked != nullptr && view.state.screen == Screen::Finale && !view.take_home.empty() &&
           look_of(configuration_.look).size != TextSize::Normal;
}

// What the plate holds, and how large.
struct Stage::PlateText {
    SignWriter::Written words;
    std::optional<SignWriter::Written> caption;
    SignWriter::Written pictogram;  // 0 wide: none
    int pad = 0;
    int steps = 0;   // height of the bars
    int below = 0;   // of the caption and what parts it from the words
    int beside = 0;  // of the pictogram and what parts it from the words
};

Stage::PlateText Stage::plate_text(const StageView& view, glm::ivec2 size) {
    const bool is_four = shows_four(view);
    const Look look = look_of(configuration_.look);
    const bool has_labels = view.asked != nullptr;
    const float em = em_px(is_four || has_labels ? Letters::Question : Letters::Statement, look.size, size.y);
    // Labels stand below it, or a code above it.
    const bool is_on_wall = view.state.screen == Screen::Attract && view.timings.is_wall;
    const bool has_code = (view.state.screen == Screen::Finale || is_on_wall) && !view.take_home.empty();
    const bool is_alone = configuration_.look.pictograms == "alone";
    const bool is_beside_code = shares_top(view);
    PlateText text;
    text.pad = static_cast<int>(em * 0.6F);
    if (configuration_.look.pictograms != "none") {
        text.pictogram = writer_.pictograms(pictograms_for(key_of(view)),
                                            static_cast<int>((is_alone ? kAlone : kBeside) * em), begins(view));
        text.beside = text.pictogram.width + (is_alone ? 0 : text.pad / 3);
    }
    if (is_alone) {
        const auto left = exhibit::countdown_s(view.state, view.now, view.timings);
        text.words = writer_.text(left ? std::to_string(*left) : "", em, true);
        if (!left) text.words.width = text.words.height = 0;
    } else {
        const int width = is_beside_code ? size.x * kBesideCode / 100 - 2 * text.pad - size.y / 10 : size.x * 8 / 10;
        const glm::ivec2 most{width - text.beside, size.y *
                                                       (is_beside_code           ? 24
                                                        : has_labels || has_code ? 18
                                                                                 : 30) /
                                                       100};
        text.words = writer_.text_within(words(view, configuration_), em, true, most);
    }
    // Words that are larger need a second line sooner; and Back wants its place below.
    const bool has_back_below =
        view.scanned != nullptr && view.scanned->offers_back && view.state.screen != Screen::Family;
    const int among_labels = look.size == TextSize::Normal ? 10 : has_back_below ? 12 : 14;
    const int most_below = size.y * (is_beside_code ? 18 : has_labels ? among_labels : has_code ? 14 : 20) / 100;
    const int width_below = is_beside_code ? size.x * kBesideCode / 100 - 2 * text.pad - size.y / 10 : size.x * 7 / 10;
    if (const auto below = line_below(view, configuration_); !below.words.empty() && (!is_alone || !below.key.empty()))
        text.caption =
            written(view, below.key, below.words,
                    {em_px(Letters::Below, look.size, size.y), look.has_high_contrast, {width_below, most_below}});
    text.below = text.caption ? text.caption->height + text.pad / 4 : 0;
    const bool has_steps = is_four && view.state.screen != exhibit::Screen::StillThere;
    text.steps = has_steps ? static_cast<int>(em * 0.55F) : 0;
    return text;
}

void Stage::add_plate(render::Frame& frame, const StageView& view) {
    const bool is_four = shows_four(view);
    const PlateText text = plate_text(view, frame.size);
    const int line = std::max(text.words.height, text.pictogram.height * 8 / 10);
    const int first = text.beside + text.words.width;  // width of the first line
    render::Rect plate{0, 0, std::max(first, text.caption ? text.caption->width : 0) + 2 * text.pad,
                       line + text.below + text.pad + text.steps};
    plate.x = (frame.size.x - plate.width) / 2;
    const bool is_mirrored = reads_right_to_left(view, configuration_);
    if (shares_top(view)) plate.x = is_mirrored ? frame.size.x - frame.size.y / 24 - plate.width : frame.size.y / 24;
    plate.y = is_four                 ? (frame.size.y - plate.height) / 2
              : view.asked != nullptr ? frame.size.y - plate.height - frame.size.y / 24
                                      : frame.size.y / 16;
    const auto corner = static_cast<float>(text.pad) / 1.2F;
    add_ground(frame, plate, corner);
    // Whatever is on the screen, a press is seen: the plate lights up in the button's colour.
    if (const float left = flash_left(view); left > 0) {
        render::Sign lit;
        lit.place = plate;
        lit.corner_radius_px = corner;
        lit.colour = glm::vec4(flash_colour(view.flash->button), left);
        lit.border_px = std::max(2.0F, static_cast<float>(text.pad) * 0.2F);
        frame.signs.push_back(lit);
    }
    const auto put = [&](const SignWriter::Written& written, int x, int middle_y) {
        render::Sign sign;
        sign.texture = written.texture;
        sign.place = {x, middle_y - written.height / 2, written.width, written.height};
        if (written.width > 0) frame.signs.push_back(sign);
    };
    const int middle = plate.y + text.pad / 2 + text.steps + text.below + line / 2;
    const int from = plate.x + (plate.width - first) / 2;
    put(text.words, is_mirrored ? from : from + text.beside, middle);
    if (text.caption)
        put(*text.caption, plate.x + (plate.width - text.caption->width) / 2,
            plate.y + text.pad / 2 + text.steps + text.caption->height / 2);
    put(text.pictogram, is_mirrored ? from + first - text.pictogram.width : from, middle);
    if (text.steps > 0) add_progress(frame, view, plate);
    add_beside_plate(frame, view, plate);
}

void Stage::add_beside_plate(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    if (view.scanned != nullptr && view.scanned->offers_back) add_back(frame, view, plate);
    const bool is_attract = view.state.screen == Screen::Attract && !view.cast.scenes.empty();
    if (is_attract && !view.timings.is_wall) {
        if (configuration_.play.shows_how) add_demonstration(frame, view, plate);
        // One after the other: both want the place above the plate.
        const bool has_ghost = configuration_.play.shows_how && ghost_at(view.now - view.state.since).has_value();
        if (view.timings.can_breed_on && !has_ghost) add_breeds_on(frame, view, plate);
    }
    const bool has_landscape = view.state.screen == Screen::Finale || (is_attract && view.timings.is_wall);
    if (has_landscape && !view.take_home.empty()) add_take_home(frame, view, plate);
    if (view.state.screen == Screen::Family) add_family(frame, view, plate);
    if (view.state.screen == Screen::Ask && exhibit::takes_turns(view.state, view.timings))
        add_turns(frame, view, plate);
    if (view.state.screen == Screen::Breed) add_chosen(frame, view, plate);
}

// What the next four grow from, below the plate while they do: of each aspect its pictogram and the button that it was
// chosen by. Each comes from the quarter that it was in.
void Stage::add_chosen(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    if (!shows_four(view) || view.state.past_answers.empty()) return;
    const genome::Pick& pick = view.state.past_answers.back();
    const Look look = look_of(configuration_.look);
    constexpr genome::PerAspect<render::Pictogram> kOfAspect{
        {render::Pictogram::Tree, render::Pictogram::Land, render::Pictogram::Sky}};
    const int badge = badge_px(look.size, frame.size.y);
    const int side = badge * 9 / 10;
    const int pad = badge / 4;
    const int each = side + badge + pad / 2;
    const render::Rect card{(frame.size.x - 3 * each - 6 * pad) / 2, plate.y - pad - badge - 2 * pad,
                            3 * each + 6 * pad, badge + 2 * pad};
    if (card.y < 0) return;
    add_ground(frame, card, static_cast<float>(pad));
    const auto places = quarters(frame.size.x, frame.size.y);
    const float gone = look.is_calm ? 1 : smooth_step(view.now - view.state.since);
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!pick[aspect]) continue;
        const std::size_t from = *pick[aspect];
        // In the order of the questions.
        const int order = static_cast<int>(aspect);
        const int index = begins(view) == SignWriter::Begins::Right ? 2 - order : order;
        const glm::ivec2 to{card.x + pad + index * (each + 2 * pad), card.y + pad};
        const render::Rect& quarter_of = places[from];
        const glm::vec2 start{static_cast<float>(quarter_of.x + (quarter_of.width - each) / 2),
                              static_cast<float>(quarter_of.y + (quarter_of.height - badge) / 2)};
        const glm::ivec2 at{glm::mix(start, glm::vec2(to), gone)};
        render::Sign sign;
        sign.texture = writer_.pictogram(kOfAspect[aspect], side).texture;
        sign.place = {at.x, at.y + (badge - side) / 2, side, side};
        frame.signs.push_back(sign);
        sign.texture = writer_.badge(from, badge).texture;
        sign.place = {at.x + side + pad / 2, at.y, badge, badge};
        frame.signs.push_back(sign);
    }
}

// Above the plate: a question, the four signs as the buttons bear them, and a finger that presses one.
void Stage::add_demonstration(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const auto ghost = ghost_at(view.now - view.state.since);
    if (!ghost) return;
    const Look look = look_of(configuration_.look);
    constexpr std::array kKeys{"ask.trees", "ask.land", "ask.sky"};
    const char* key = kKeys[static_cast<std::size_t>(ghost->question)];
    const auto question =
        written(view, key, site::text(configuration_, key, view.language),
                {em_px(Letters::Below, look.size, frame.size.y), true, {frame.size.x * 7 / 10, frame.size.y / 6}});
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
    if (shares_top(view)) return add_take_home_beside(frame, view, plate);
    const Look look = look_of(configuration_.look);
    const int inset = frame.size.y / 24;
    const int pad = frame.size.y / 60;
    const float em = em_px(Letters::Below, look.size, frame.size.y);
    const int most = frame.size.y * kCodeShare / 100;
    auto code = writer_.code(std::string(view.take_home), most);
    const float lines = look.size == TextSize::Normal ? kCodeLines : kLargeCodeLines;
    const auto words = written(view, "take-home", site::text(configuration_, "take-home", view.language),
                               {em, true, {std::max(most, frame.size.x * 28 / 100), static_cast<int>(lines * em)}});
    const auto width_of = [&] { return std::max(code.width, words.width) + 2 * pad; };
    const bool is_below = view.asked != nullptr;  // of the plate, then: labels lie at the bottom
    const bool is_beside = is_below || plate.x + plate.width + inset / 2 <= frame.size.x - inset - width_of();
    const int bottom = is_below    ? labels_top(frame.size.y) + pad
                       : is_beside ? plate.y
                                   : plate.y + plate.height + inset / 2;
    const int top = is_below ? plate.y : frame.size.y;
    const int room = top - bottom - inset / 2 - words.height - 3 * pad;
    if (room < code.height) code = writer_.code(std::string(view.take_home), room);
    if (code.width == 0) return;
    const int left = reads_right_to_left(view, configuration_) ? inset : frame.size.x - inset - width_of();
    const render::Rect card{left, bottom, width_of(), code.height + words.height + 3 * pad};
    add_code(frame, card, {card.x + (card.width - code.width) / 2, card.y + card.height - pad - code.height}, code);
    add_words(frame, words, {card.x + (card.width - words.width) / 2, card.y + pad});
}

// What it is for stands before it then, in what the plate leaves.
void Stage::add_take_home_beside(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const Look look = look_of(configuration_.look);
    const int inset = frame.size.y / 24;
    const int pad = frame.size.y / 60;
    const int free_height = frame.size.y - inset - labels_top(frame.size.y) - inset / 2;
    const auto code =
        writer_.code(std::string(view.take_home), std::min(free_height - 2 * pad, frame.size.y * kCodeShare / 100));
    if (code.width == 0) return;
    const int free_width = frame.size.x - 2 * inset - plate.width - inset / 2;
    const std::string says = site::text(configuration_, "take-home", view.language);
    const Room room{
        em_px(Letters::Below, look.size, frame.size.y), true, {free_width - code.width - 4 * pad, code.height}};
    const auto words = configuration_.look.pictograms == "alone"
                           ? written(view, "take-home", says, room)
                           : writer_.text_within(says, room.em_px, room.is_bold, room.most_px);
    const int width = code.width + words.width + 3 * pad;
    const bool is_mirrored = reads_right_to_left(view, configuration_);
    const render::Rect card{is_mirrored ? inset : frame.size.x - inset - width,
                            frame.size.y - inset - code.height - 2 * pad, width, code.height + 2 * pad};
    const int code_x = is_mirrored ? card.x + pad : card.x + card.width - pad - code.width;
    const int words_x = is_mirrored ? code_x + code.width + pad : card.x + pad;
    add_code(frame, card, {code_x, card.y + pad}, code);
    add_words(frame, words, {words_x, card.y + (card.height - words.height) / 2});
}

void Stage::add_code(render::Frame& frame, const render::Rect& card, glm::ivec2 at, const SignWriter::Written& code) {
    add_ground(frame, card, static_cast<float>(frame.size.y / 60));
    add_words(frame, code, at);
}

void Stage::add_words(render::Frame& frame, const SignWriter::Written& words, glm::ivec2 at) {
    render::Sign sign;
    sign.texture = words.texture;
    sign.place = {at.x, at.y, words.width, words.height};
    frame.signs.push_back(sign);
}

// Below the question, in the same hand; beside the arrows where a tree is in the middle.
void Stage::add_back(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const float em = em_px(Letters::Label, look_of(configuration_.look).size, frame.size.y);
    const glm::ivec2 most{frame.size.x * 3 / 10, frame.size.y * 8 / 100};
    // Its words have an arrow of their own.
    const auto words = configuration_.look.pictograms == "alone"
                           ? writer_.said_within(pictograms_for("back"), "", em, true, most, SignWriter::Begins::Left)
                           : writer_.text_within(site::text(configuration_, "back", view.language), em, true, most);
    const int pad = static_cast<int>(em * 0.6F);
    const int gap = mark_reach_px(frame.size.y) + frame.size.y / 180;
    render::Rect back{0, 0, words.width + 2 * pad, words.height + pad};
    back.x = (frame.size.x - back.width) / 2;
    back.y = plate.y - gap - back.height;
    if (view.state.screen == Screen::Family) {
        back.x = beside_arrows(frame.size.y) + mark_reach_px(frame.size.y);
        back.y = frame.size.y / 24 + (lower_row(frame.size.y) - back.height) / 2;
    }
    add_ground(frame, back, em * 0.5F);
    render::Sign sign;
    sign.texture = words.texture;
    sign.place = {back.x + pad, back.y + pad / 2, words.width, words.height};
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
