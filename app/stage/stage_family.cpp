// SPDX-License-Identifier: Apache-2.0
// What a visit has seen, drawn as a tree: time runs from left to right, each four as a card, and what was chosen leads
// from one to the next. The card that is walked to is large, as under a lens; the others keep their order around it.
#include <algorithm>
#include <cmath>

#include "exhibit/family.hpp"
#include "stage/easel.hpp"
#include "stage/marks.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {
namespace {

constexpr glm::vec4 kLine{1, 1, 1, 0.45F};
constexpr glm::vec4 kLineHome{1, 1, 1, 0.95F};  // from the first four to the Finale's landscape
constexpr glm::vec4 kEdge{1, 1, 1, 0.6F};
constexpr float kLarge = 0.44F;      // of the room's width, the large card at most
constexpr float kHigh = 0.8F;        // of its height
constexpr float kAmongRows = 0.6F;   // the same where cards lie above and below it,
constexpr float kLow = 0.17F;        // and these at most
constexpr float kSmallest = 0.055F;  // and a small one at least; beyond the edges the tree is not drawn
constexpr int kHighEnough = 33;      // of the picture, in hundredths, what the tree needs
constexpr float kGap = 0.24F;        // between cards, of a small card's width

struct Lens {
    glm::ivec2 large, small;
    int gap = 0;
    int row = 0;  // from one row to the next
    glm::ivec2 middle;
};

// Sizes have the picture's shape.
Lens lens_for(const render::Rect& room, glm::ivec2 picture, int columns, int rows) {
    const auto width = static_cast<float>(room.width);
    const float shape = static_cast<float>(picture.y) / static_cast<float>(picture.x);
    const float height = static_cast<float>(room.height) / shape;  // as wide as that is high
    const float large = std::min(kLarge * width, (rows > 1 ? kAmongRows : kHigh) * height);
    const float each = (width - large) / (static_cast<float>(std::max(columns - 1, 1)) * (1 + kGap) + kGap);
    const float small = std::clamp(each, kSmallest * width, rows > 1 ? kLow * height : large / 2.4F);
    Lens lens;
    lens.large = glm::ivec2(glm::vec2(large, large * shape));
    lens.small = glm::ivec2(glm::vec2(small, small * shape));
    lens.gap = static_cast<int>(kGap * small);
    lens.row = lens.small.y + std::max(2, lens.small.y / 9);
    lens.middle = {room.x + room.width / 2, room.y + room.height / 2};
    return lens;
}

// Where each card lies; the one that is walked to is in the middle of the room's height, and of its width unless all
// of the tree has room.
std::vector<render::Rect> cards_in(const render::Rect& room, const Lens& lens,
                                   const std::vector<exhibit::FamilyPlace>& places, int walked) {
    const exhibit::FamilyPlace at = places[static_cast<std::size_t>(walked)];
    int columns = 1;
    for (const exhibit::FamilyPlace& place : places) columns = std::max(columns, place.column + 1);
    const int pitch = lens.small.x + lens.gap;
    const int whole = (columns - 1) * pitch + lens.large.x;
    int left = room.x + (room.width - whole) / 2;
    if (whole > room.width) left = lens.middle.x - lens.large.x / 2 - at.column * pitch;
    std::vector<render::Rect> cards;
    for (std::size_t node = 0; node < places.size(); ++node) {
        const bool is_large = static_cast<int>(node) == walked;
        const int past = places[node].column - at.column;
        const int below = places[node].row - at.row;
        const glm::ivec2 size = is_large ? lens.large : lens.small;
        int x = left + places[node].column * pitch + (past > 0 ? lens.large.x - lens.small.x : 0);
        int y = lens.middle.y - below * lens.row - size.y / 2;
        if (past == 0 && !is_large) {
            x += (lens.large.x - lens.small.x) / 2;
            const int beside = (lens.large.y - lens.small.y) / 2;  // above or below the large one
            y -= below > 0 ? beside : -beside;
        }
        cards.push_back({x, y, size.x, size.y});
    }
    return cards;
}

bool lies_in(const render::Rect& card, const render::Rect& room) {
    return card.x >= room.x && card.y >= room.y && card.x + card.width <= room.x + room.width &&
           card.y + card.height <= room.y + room.height;
}

void add_bar(render::Frame& frame, glm::ivec2 from, glm::ivec2 to, int thick, const glm::vec4& colour) {
    render::Sign bar;
    bar.place = {std::min(from.x, to.x) - thick / 2, std::min(from.y, to.y) - thick / 2,
                 std::abs(to.x - from.x) + thick, std::abs(to.y - from.y) + thick};
    bar.colour = colour;
    bar.corner_radius_px = static_cast<float>(thick) / 2;
    frame.signs.push_back(bar);
}

}  // namespace

// One a frame, the one that is walked to first: each takes a millisecond or two.
void Stage::bring_family(const StageView& view) {
    const auto bring = [&](int node) {
        const Miniatures::Miniature* kept = view.miniatures == nullptr ? nullptr : view.miniatures->find(node);
        FamilyPicture& picture = family_[node];
        if (kept == nullptr || picture.number == kept->number) return false;
        picture = {kept->number, renderer_.texture(kept->picture)};
        return true;
    };
    if (bring(view.state.walked)) return;
    for (int node = 0; node < static_cast<int>(view.state.family.size()); ++node)
        if (bring(node)) return;
}

void Stage::add_family_lines(render::Frame& frame, const StageView& view, const std::vector<render::Rect>& cards) {
    const auto& family = view.state.family;
    std::vector<bool> leads_home(family.size());
    for (int node = view.state.here; node >= 0; node = family[static_cast<std::size_t>(node)].parent)
        leads_home[static_cast<std::size_t>(node)] = true;
    const int thick = std::max(3, frame.size.y / 240);
    // Those that lead to the landscape lie over the others.
    for (const bool is_home : {false, true})
        for (std::size_t node = 0; node < family.size(); ++node) {
            if (family[node].parent < 0 || leads_home[node] != is_home) continue;
            const render::Rect& from = cards[static_cast<std::size_t>(family[node].parent)];
            const render::Rect& to = cards[node];
            const glm::ivec2 start{from.x + from.width, from.y + from.height / 2};
            const glm::ivec2 end{to.x, to.y + to.height / 2};
            const int bend = std::max(start.x, end.x - std::max(thick, (end.x - start.x) / 2));
            const glm::vec4& colour = is_home ? kLineHome : kLine;
            add_bar(frame, start, {bend, start.y}, thick, colour);
            if (start.y != end.y) add_bar(frame, {bend, start.y}, {bend, end.y}, thick, colour);
            add_bar(frame, {bend, end.y}, end, thick, colour);
        }
}

// Which button each aspect was chosen by, on the quarter that it was in: where the large card leads on toward the
// landscape.
void Stage::add_picked(render::Frame& frame, const StageView& view, const render::Rect& card) {
    const exhibit::State& state = view.state;
    if (!state.family[static_cast<std::size_t>(state.walked)].was_seen) return;
    const int badge = std::min(card.height / 7, badge_px(look_of(configuration_.look).size, frame.size.y));
    const int inset = badge / 5;
    const auto places = quarters(card.width, card.height);
    const auto put = [&](const std::shared_ptr<const render::Texture>& texture, int x, int y) {
        render::Sign sign;
        sign.texture = texture;
        sign.place = {card.x + x, card.y + y, badge, badge};
        frame.signs.push_back(sign);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool is_left = i % 2 == 0, is_upper = i < 2;
        put(writer_.badge(i, badge).texture,
            is_left ? places[i].x + inset : places[i].x + places[i].width - inset - badge,
            is_upper ? places[i].y + places[i].height - inset - badge : places[i].y + inset);
    }
    const auto next = exhibit::step_to(state.family, state.walked, exhibit::Choice::B, state.here);
    if (!next) return;
    constexpr genome::PerAspect<render::Pictogram> kOfAspect{
        {render::Pictogram::Tree, render::Pictogram::Land, render::Pictogram::Sky}};
    std::array<int, kQuarters> taken{};
    const auto& pick = state.family[static_cast<std::size_t>(*next)].pick;
    // In the middle of the quarter's outer edge, beside the badge, on a ground as wide as there are.
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto count =
            static_cast<int>(std::ranges::count_if(genome::kAspects, [&](genome::Aspect a) { return pick[a] == i; }));
        if (count == 0) continue;
        const bool is_left = i % 2 == 0, is_upper = i < 2;
        const int width = count * badge;
        const int x =
            is_left ? places[i].x + 2 * inset + badge : places[i].x + places[i].width - 2 * inset - badge - width;
        const int y = is_upper ? places[i].y + places[i].height - inset - badge : places[i].y + inset;
        add_ground(frame, {card.x + x, card.y + y, width, badge}, static_cast<float>(badge) / 4);
        for (const genome::Aspect aspect : genome::kAspects)
            if (pick[aspect] == i) put(writer_.pictogram(kOfAspect[aspect], badge).texture, x + taken[i]++ * badge, y);
    }
}

void Stage::add_family_card(render::Frame& frame, const StageView& view, int node, const render::Rect& card) {
    const bool is_walked = node == view.state.walked;
    const int edge = std::max(2, frame.size.y / (is_walked ? 160 : 360));
    render::Sign sign;
    sign.place = {card.x - edge, card.y - edge, card.width + 2 * edge, card.height + 2 * edge};
    sign.corner_radius_px = static_cast<float>(2 * edge);
    sign.colour = is_walked ? glm::vec4{1} : kEdge;
    frame.signs.push_back(sign);
    sign.place = card;
    sign.corner_radius_px = 0;
    sign.colour = {0.1F, 0.11F, 0.12F, 1};
    const auto picture = family_.find(node);
    const bool has_picture = picture != family_.end() && picture->second.texture != nullptr;
    if (has_picture) {
        sign.texture = picture->second.texture;
        sign.colour = glm::vec4{1};
    }
    frame.signs.push_back(sign);
    const bool is_finale = !view.state.family[static_cast<std::size_t>(node)].was_seen;
    if (has_picture && !is_finale) return;
    const int side = std::min(card.height / (is_finale && is_walked ? 4 : 2), card.width);
    sign.colour = glm::vec4{1};
    sign.texture = writer_.pictogram(is_finale ? render::Pictogram::Frame : render::Pictogram::Sprout, side).texture;
    sign.place = {card.x + card.width - side - edge, card.y + edge, side, side};
    frame.signs.push_back(sign);
}

void Stage::add_family(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const exhibit::State& state = view.state;
    if (state.family.empty()) return;
    bring_family(view);
    const int margin = frame.size.y / 40;
    const int bottom = labels_top(frame.size.y);
    render::Rect room{margin, bottom, frame.size.x - 2 * margin, plate.y - bottom - margin};
    // Large labels leave little above them: then between the arrows of the upper two.
    if (room.height < frame.size.y * kHighEnough / 100) {
        room.x = beside_arrows(frame.size.y) + margin;
        room.width = frame.size.x - 2 * room.x;
        room.y = frame.size.y / 24 + lower_row(frame.size.y) + 2 * mark_reach_px(frame.size.y);
        room.height = plate.y - room.y - margin;
    }
    const auto places = exhibit::places_of(state.family);
    int columns = 1, rows = 1;
    for (const exhibit::FamilyPlace& place : places) {
        columns = std::max(columns, place.column + 1);
        rows = std::max(rows, place.row + 1);
    }
    const Lens lens = lens_for(room, frame.size, columns, rows);
    const auto cards = cards_in(room, lens, places, state.walked);
    const std::size_t first = frame.signs.size();
    add_family_lines(frame, view, cards);
    // What would stick out is behind the edge.
    std::erase_if(frame.signs, [&, i = std::size_t{0}](const render::Sign& sign) mutable {
        return i++ >= first && !lies_in(sign.place, room);
    });
    for (std::size_t node = 0; node < cards.size(); ++node)
        if (static_cast<int>(node) != state.walked && lies_in(cards[node], room))
            add_family_card(frame, view, static_cast<int>(node), cards[node]);
    const render::Rect& large = cards[static_cast<std::size_t>(state.walked)];
    add_family_card(frame, view, state.walked, large);
    add_picked(frame, view, large);
}

// Who answers which question: three people below the plate, the one whose turn it is bright.
void Stage::add_turns(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    const int side = badge_px(look_of(configuration_.look).size, frame.size.y);
    const int pad = side / 4;
    render::Rect card{0, 0, 3 * side + 4 * pad, side + pad};
    card.x = (frame.size.x - card.width) / 2;
    card.y = plate.y + plate.height + pad;  // above: Back may stand below
    if (card.y + card.height > frame.size.y) return;
    add_ground(frame, card, static_cast<float>(pad));
    const bool is_mirrored = reads_right_to_left(view, configuration_);
    const int turn = static_cast<int>(view.state.question);
    for (int i = 0; i < 3; ++i) {
        const int place = is_mirrored ? 2 - i : i;
        render::Sign sign;
        sign.texture = writer_.pictogram(render::Pictogram::Person, side).texture;
        sign.place = {card.x + pad + place * (side + pad), card.y + pad / 2, side, side};
        sign.colour.a = i == turn ? 1.0F : 0.28F;
        frame.signs.push_back(sign);
    }
}

// In a corner: which button breeds on from what is shown.
void Stage::add_breeds_on(render::Frame& frame, const StageView& view, const render::Rect& plate) {
    constexpr std::size_t kButton = 3;
    const Look look = look_of(configuration_.look);
    const int badge = badge_px(look.size, frame.size.y);
    const int pad = std::max(4, frame.size.y / 90);
    const int inset = frame.size.y / 24;
    const SignWriter::Written words =
        written(view, "breed-on", site::text(configuration_, "breed-on", view.language),
                {em_px(Letters::Label, look.size, frame.size.y), true, {frame.size.x * 3 / 10, badge + badge / 2}});
    const int height = std::max(badge, words.height) + 2 * pad;
    const int width = badge + words.width + 3 * pad;
    render::Rect card{frame.size.x - inset - width, plate.y, width, height};
    // Beside the plate where there is room, else above it.
    if (card.x < plate.x + plate.width + pad) card.y = plate.y + plate.height + pad;
    add_ground(frame, card, static_cast<float>(pad));
    render::Sign sign;
    sign.texture = writer_.badge(kButton, badge).texture;
    sign.place = {card.x + pad, card.y + (height - badge) / 2, badge, badge};
    frame.signs.push_back(sign);
    sign.texture = words.texture;
    sign.place = {card.x + badge + 2 * pad, card.y + (height - words.height) / 2, words.width, words.height};
    frame.signs.push_back(sign);
}

}  // namespace quadrat::stage
