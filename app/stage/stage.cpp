// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "genome/speech.hpp"
#include "nursery/gallery.hpp"
#include "stage/easel.hpp"
#include "stage/marks.hpp"
#include "stage/pictograms.hpp"

namespace quadrat::stage {
namespace {

using exhibit::Screen;

constexpr float kGrowInSeconds = 2.0F;
constexpr float kFlashSeconds = 0.4F;
constexpr float kAttractSceneSeconds = std::chrono::duration<float>(nursery::Gallery::kShownFor).count();
constexpr float kCalmFadeSeconds = 1.5F;  // of what comes and goes where nothing may move

float seconds_of(base::Instant t) { return std::chrono::duration<float>(t).count(); }

float smooth(float x) {
    const float t = std::clamp(x, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

float dimming(const StageView& view, const Look& look) {
    const float since = seconds_of(view.now - view.state.since);
    if (view.state.screen == exhibit::Screen::Breed)
        return 0.45F * smooth(since / (look.is_calm ? kCalmFadeSeconds : 0.5F));
    if (view.state.screen == exhibit::Screen::StillThere) return 0.35F;
    if (view.state.screen == exhibit::Screen::Family) return 0.62F;
    return 0;
}

// Out of the dark, each time that another landscape comes.
float fading(const StageView& view) {
    const float on_stage = seconds_of(view.now - view.cast.arrived);
    const bool is_attract = view.state.screen == exhibit::Screen::Attract;
    return 1 - smooth((is_attract ? std::fmod(on_stage, kAttractSceneSeconds) : on_stage) / kCalmFadeSeconds);
}

// For a moment, where one landscape of several takes another's place in Attract: seasons pass over the same land
// without a jump.
float dip(const StageView& view) {
    constexpr float kDipSeconds = 0.7F;
    const float on_stage = seconds_of(view.now - view.cast.arrived);
    const bool changes = view.state.screen == exhibit::Screen::Attract && view.cast.scenes.size() > 1;
    if (!changes || on_stage < 0.5F * kAttractSceneSeconds) return 0;
    const float since = std::fmod(on_stage, kAttractSceneSeconds);
    return 1 - smooth(std::min(since, kAttractSceneSeconds - since) / kDipSeconds);
}

std::optional<std::size_t> marked_quarter(const StageView& view) {
    if (view.scanned == nullptr || !view.scanned->marked || *view.scanned->marked == exhibit::Choice::Back)
        return std::nullopt;
    return static_cast<std::size_t>(*view.scanned->marked);
}

std::size_t attract_index(const StageView& view) {
    const auto turn = static_cast<std::size_t>(seconds_of(view.now - view.cast.arrived) / kAttractSceneSeconds);
    return turn % view.cast.scenes.size();
}

}  // namespace

bool shows_four(const StageView& view) {
    return view.cast.scenes.size() == genome::kCandidates && view.state.screen != exhibit::Screen::Attract &&
           view.state.screen != exhibit::Screen::Finale && view.state.screen != exhibit::Screen::Family;
}

float flash_left(const StageView& view) {
    if (!view.flash) return 0;
    return 1 - smooth(seconds_of(view.now - view.flash->at) / kFlashSeconds);
}

bool is_written_from_the_right(const std::string& language) { return genome::language(language).reads_right_to_left(); }

bool reads_right_to_left(const StageView& view, const site::Configuration& configuration) {
    return is_written_from_the_right(view.language.empty() ? configuration.visit.language : std::string(view.language));
}

std::string_view key_of(const StageView& view) {
    if (view.cast.scenes.empty() && view.backdrop == nullptr) return "first";
    switch (exhibit::prompt_of(view.state)) {
        case exhibit::Prompt::PressAnyButton:
            return view.timings.is_wall ? "finale" : "attract";
        case exhibit::Prompt::BestTrees:
            return "ask.trees";
        case exhibit::Prompt::BestLand:
            return "ask.land";
        case exhibit::Prompt::BestSky:
            return "ask.sky";
        case exhibit::Prompt::Growing:
            return "breed";
        case exhibit::Prompt::StillThere:
            return "still-there";
        case exhibit::Prompt::WhichWords:
        case exhibit::Prompt::TurnWords:
            return view.asked != nullptr ? std::string_view(view.asked->prompt) : "finale";
        case exhibit::Prompt::WhichLanguage:
            return "ask.language";
        case exhibit::Prompt::WhichAncestor:
            return "family";
        case exhibit::Prompt::YourLandscape:
            break;
    }
    return "finale";
}

std::string words(const StageView& view, const site::Configuration& configuration) {
    const std::string_view key = key_of(view);
    const bool is_hung = exhibit::prompt_of(view.state) == exhibit::Prompt::PressAnyButton && key == "finale";
    if (is_hung) return std::string(view.caption);  // on a wall
    const std::string said = site::text(configuration, std::string(key), view.language);
    const auto left = exhibit::countdown_s(view.state, view.now, view.timings);
    return left && key != "first" ? fmt::format("{}  {}", said, *left) : said;
}

render::Frame Stage::frame(const StageView& view, const display::Canvas& canvas) {
    render::Frame frame;
    frame.hanging = {static_cast<int>(canvas.rotation), canvas.mirroring == display::Mirroring::Mirrored};
    frame.size = render::turned_size({canvas.size.width, canvas.size.height}, frame.hanging);
    frame.framebuffer = canvas.framebuffer;
    frame.seconds = seconds_of(view.now);
    frame.detail.alpha = static_cast<float>(configuration_.picture.alpha);
    const bool is_covered = view.board != nullptr && view.board->cover == Board::Cover::All;
    if (!is_covered && view.backdrop != nullptr)
        add_backdrop(frame, *view.backdrop);
    else if (!is_covered)
        add_views(frame, view);
    const bool is_strip = view.board != nullptr && view.board->cover == Board::Cover::Strip;
    if (view.board != nullptr && !is_strip) {
        add_board(frame, *view.board);
        return frame;
    }
    if (shows_four(view)) add_quarter_signs(frame, view);
    add_plate(frame, view);
    if (view.asked != nullptr) add_labels(frame, view);
    if (!view.sign.empty()) add_sign(frame, view.sign);
    if (is_strip) add_strip(frame, *view.board);
    frame.is_wired = is_strip && view.board->has_wires;
    return frame;
}

void Stage::add_views(render::Frame& frame, const StageView& view) {
    if (view.cast.scenes.empty()) return;
    const Look look = look_of(configuration_.look);
    const float on_stage = seconds_of(view.now - view.cast.arrived);
    const auto add = [&](const Shown& shown, const render::Rect& place) {
        render::View one;
        one.scene = shown.gpu;
        // The flight starts with the cast, so that the four are compared from where the camera stands first.
        one.camera = scene::camera_at(shown.scene->track, look.is_calm ? 0 : on_stage);
        one.viewport = place;
        one.growth = look.is_calm ? 1 : std::clamp(on_stage / kGrowInSeconds, 0.0F, 1.0F);
        one.dim = std::max(dimming(view, look), look.is_calm ? fading(view) : dip(view));
        frame.views.push_back(std::move(one));
    };
    if (shows_four(view)) {
        const auto places = quarters(frame.size.x, frame.size.y);
        for (std::size_t i = 0; i < places.size(); ++i) add(view.cast.scenes[i], places[i]);
    } else {
        const std::size_t one = view.state.screen == exhibit::Screen::Attract ? attract_index(view) : 0;
        add(view.cast.scenes[one], {0, 0, frame.size.x, frame.size.y});
    }
}

void Stage::add_ground(render::Frame& frame, const render::Rect& place, float corner_px) {
    const Look look = look_of(configuration_.look);
    render::Sign sign;
    sign.place = place;
    sign.colour = plate_colour(look);
    sign.corner_radius_px = corner_px;
    frame.signs.push_back(sign);
    if (!look.has_high_contrast) return;
    sign.colour = glm::vec4{1};
    sign.border_px = std::max(1.0F, static_cast<float>(frame.size.y) / 360.0F);
    frame.signs.push_back(sign);
}

void Stage::add_quarter_signs(render::Frame& frame, const StageView& view) {
    const auto places = quarters(frame.size.x, frame.size.y);
    const float border = std::max(3.0F, static_cast<float>(frame.size.y) / 120.0F);
    if (const float left = flash_left(view); left > 0 && view.flash->button != exhibit::Choice::Back) {
        const auto index = static_cast<std::size_t>(view.flash->button);
        render::Sign sign;
        sign.place = places[index];
        sign.colour = glm::vec4(glm::vec3(quarter(index).colour), 0.2F + 0.8F * left);
        sign.border_px = border * 1.6F;
        frame.signs.push_back(sign);
    }
    const auto marked = marked_quarter(view);
    if (marked) add_mark(frame, places[*marked], glm::vec3(quarter(*marked).colour), Corners::Bracketed);
    for (auto& sign : writer_.badges(frame.size.x, frame.size.y, look_of(configuration_.look).size, marked))
        frame.signs.push_back(std::move(sign));
}

void Stage::add_backdrop(render::Frame& frame, const mesh::Image& picture) {
    // As much of it as fills the screen, in the middle.
    const float scale = std::max(static_cast<float>(frame.size.x) / static_cast<float>(picture.width),
                                 static_cast<float>(frame.size.y) / static_cast<float>(picture.height));
    render::Sign sign;
    sign.texture = writer_.picture(picture);
    sign.place.width = static_cast<int>(std::ceil(static_cast<float>(picture.width) * scale));
    sign.place.height = static_cast<int>(std::ceil(static_cast<float>(picture.height) * scale));
    sign.place.x = (frame.size.x - sign.place.width) / 2;
    sign.place.y = (frame.size.y - sign.place.height) / 2;
    frame.signs.push_back(sign);
}

// Lines above one another in the lower left corner.
void Stage::add_strip(render::Frame& frame, const Board& board) {
    const int pad = frame.size.y / 90;
    int y = pad;
    for (auto line = board.lines.rbegin(); line != board.lines.rend(); ++line) {
        const auto written = writer_.text(*line, static_cast<float>(frame.size.y) / 45.0F);
        add_ground(frame, {0, y - pad, written.width + 2 * pad, written.height + 2 * pad}, 0);
        render::Sign sign;
        sign.texture = written.texture;
        sign.place = {pad, y, written.width, written.height};
        frame.signs.push_back(sign);
        y += written.height + 2 * pad;
    }
}

// In the lower right corner, where whoever looks for it finds it and nobody else minds.
void Stage::add_sign(render::Frame& frame, std::string_view words) {
    const int pad = frame.size.y / 120;
    const auto written =
        writer_.text(std::string(words), static_cast<float>(frame.size.y) / 45.0F, false, frame.size.x * 4 / 10);
    const int left = frame.size.x - written.width - 2 * pad;
    add_ground(frame, {left, 0, written.width + 2 * pad, written.height + 2 * pad}, 0);
    render::Sign sign;
    sign.texture = written.texture;
    sign.place = {left + pad, pad, written.width, written.height};
    frame.signs.push_back(sign);
}

// The title large; the lines below it, small enough that all of them are on the screen.
void Stage::add_board(render::Frame& frame, const Board& board) {
    const int margin = frame.size.y / 20;
    render::Sign back;
    back.place = {0, 0, frame.size.x, frame.size.y};
    back.colour = board.cover == Board::Cover::All ? glm::vec4{0.05F, 0.06F, 0.07F, 1} : plate_colour({});
    frame.signs.push_back(back);
    const int most_width = frame.size.x - 2 * margin;
    const float title_em = static_cast<float>(frame.size.y) / (board.lines.empty() ? 9.0F : 16.0F);
    // Closed, there is one thing to say, to who does not read too.
    const auto row =
        configuration_.look.pictograms == "none" ? std::span<const render::Pictogram>{} : pictograms_for(board.prompt);
    const bool is_alone = configuration_.look.pictograms == "alone" && !row.empty();
    const auto title = writer_.said_within(row, is_alone ? "" : board.title, title_em, true,
                                           {most_width, frame.size.y / 2}, SignWriter::Begins::Left);
    render::Sign sign;
    sign.texture = title.texture;
    sign.place = {margin, frame.size.y - margin - title.height, title.width, title.height};
    if (board.lines.empty())
        sign.place = {(frame.size.x - title.width) / 2, (frame.size.y - title.height) / 2, title.width, title.height};
    frame.signs.push_back(sign);
    const float room = static_cast<float>(sign.place.y - 2 * margin);
    const float leading = std::min(room / static_cast<float>(std::max<std::size_t>(board.lines.size(), 1)),
                                   static_cast<float>(frame.size.y) / 20.0F);
    float top = static_cast<float>(sign.place.y) - static_cast<float>(margin) / 2;
    for (const std::string& line : board.lines) {
        const auto written = writer_.text(line, leading * 0.62F);
        // A line that is too wide is drawn smaller, not cut.
        const float shrink = std::min(1.0F, static_cast<float>(most_width) / static_cast<float>(written.width));
        sign.texture = written.texture;
        sign.place.width = static_cast<int>(static_cast<float>(written.width) * shrink);
        sign.place.height = static_cast<int>(static_cast<float>(written.height) * shrink);
        sign.place.x = margin;
        sign.place.y = static_cast<int>(top) - sign.place.height;
        frame.signs.push_back(sign);
        top -= leading;
    }
}

}  // namespace quadrat::stage
