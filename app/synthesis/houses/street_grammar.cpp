// SPDX-License-Identifier: Apache-2.0
// Procedural modelling of cities (Parish & Müller 2001): an L-system whose lanes' ends ask for their next step. Global
// goals (raster, radial, the slope) propose it, local constraints (water, steep ground, other lanes) turn it, join it
// to a lane, carry it over a brook, or end it. Where they write functions into successors, a lane's end is followed by
// a module that is asked of the land between derivation steps, as open L-systems have it (Měch & Prusinkiewicz 1996),
// so that the grammar is a text and its engine the trees'.
#include "synthesis/houses/street_grammar.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <optional>

namespace quadrat::synthesis::houses {
namespace {

constexpr float kSteepest = 0.24F;  // of a lane
constexpr float kApart_m = 15;      // from other lanes, but where it begins
constexpr float kMeets_m = 9;       // another lane that it comes as near to as that
constexpr float kShortest_m = 20;
constexpr float kFarthest_m = 300;  // from the middle
constexpr std::size_t kMostLanes = 72;
constexpr std::size_t kMostCrossings = 3;
constexpr float kCrossingsApart_m = 60;
constexpr float kWidest_m = 25;       // water that is crossed
constexpr float kOverWater_m = 4.5F;  // its banks, at most
constexpr std::size_t kOwnWay = 4;    // points until a lane must keep from what it left
constexpr int kMostSteps = 120;

glm::vec2 toward(float deg) { return {std::cos(glm::radians(deg)), std::sin(glm::radians(deg))}; }

// In degrees, -180 to 180.
float turn_between(glm::vec2 from, glm::vec2 to) {
    return glm::degrees(std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to)));
}

const lsystem::Grammar& grammar_of(Streets pattern) {
    static const std::map<std::string_view, lsystem::Grammar> kRead = [] {
        std::map<std::string_view, lsystem::Grammar> read;
        for (const NamedStreets& one : street_library())
            read.emplace(one.name, lsystem::read_grammar(one.text, std::string(one.name)));
        return read;
    }();
    constexpr std::string_view kNames[] = {"raster", "radial", "organic"};
    return kRead.at(kNames[static_cast<std::size_t>(pattern)]);
}

// A word as lanes, and the ends that ask.
struct Drawing {
    struct Line {
        Branch branch;
        bool has_met = false;
        glm::vec2 low_m{0}, high_m{0};  // the rectangle about it

        bool is_near(glm::vec2 at_m, float reach_m) const {
            return at_m.x > low_m.x - reach_m && at_m.x < high_m.x + reach_m && at_m.y > low_m.y - reach_m &&
                   at_m.y < high_m.y + reach_m;
        }
    };
    struct Question {
        std::size_t symbol = 0;
        glm::vec2 at_m{0};
        float heading_deg = 0;
        int line = -1;  // whose end it is; -1: one that begins here
        int from = -1;  // the line it leaves, if it begins here
    };
    std::vector<Line> lines;
    std::vector<Question> questions;
};

class Pen {
  public:
    Pen(const lsystem::Word& word, float width_m) : word_(word) { state_.width_m = width_m; }

    Drawing drawn() {
        for (std::size_t i = 0; i < word_.symbols.size(); ++i) draw(i);
        return std::move(drawing_);
    }

  private:
    struct State {
        glm::vec2 at_m{0};
        float heading_deg = 0;
        int line = -1;
        int from = -1;
        float from_at_m = 0;
        float width_m = 2.6F;
        bool is_road = false;
    };

    float value(const lsystem::Word::Symbol& symbol, std::uint32_t k) const { return word_.values[symbol.first + k]; }

    void draw(std::size_t i) {
        const lsystem::Word::Symbol& symbol = word_.symbols[i];
        switch (symbol.letter) {
            case '[':
                stack_.push_back(state_);
                if (state_.line >= 0) leave();
                break;
            case ']':
                state_ = stack_.back();
                stack_.pop_back();
                break;
            case 'M':
                state_ = {{value(symbol, 0), value(symbol, 1)},
                          value(symbol, 2),
                          -1,
                          -1,
                          0,
                          value(symbol, 3),
                          value(symbol, 4) > 0};
                break;
            case '+':
                state_.heading_deg += value(symbol, 0);
                break;
            case '-':
                state_.heading_deg -= value(symbol, 0);
                break;
            case 'F':
            case 'G':
            case 'W':
                walk(value(symbol, 0), symbol.letter == 'W');
                break;
            case '?':
                drawing_.questions.push_back({i, state_.at_m, state_.heading_deg, state_.line, state_.from});
                break;
            default:
                break;
        }
    }

    Lane& lane() { return drawing_.lines[static_cast<std::size_t>(state_.line)].branch.lane; }

    void leave() {
        state_.from = state_.line;
        state_.from_at_m = kLaneStep_m * static_cast<float>(lane().line_m.size() - 1);
        state_.line = -1;
        // What leaves a road is no road.
        if (state_.is_road) state_.width_m = lane_width_m_;
        state_.is_road = false;
    }

    void walk(float length_m, bool is_over_water) {
        if (state_.line < 0) {
            state_.line = static_cast<int>(drawing_.lines.size());
            drawing_.lines.push_back(
                {{{{state_.at_m}, state_.width_m, state_.is_road, {}}, state_.from, state_.from_at_m},
                 false,
                 state_.at_m,
                 state_.at_m});
        }
        const std::size_t from = lane().line_m.size() - 1;
        const glm::vec2 way = toward(state_.heading_deg);
        const int steps = is_over_water ? static_cast<int>(std::lround(length_m / kLaneStep_m)) : 1;
        for (int k = 0; k < steps; ++k) {
            state_.at_m += way * (length_m / static_cast<float>(steps));
            lane().line_m.push_back(state_.at_m);
        }
        Drawing::Line& line = drawing_.lines[static_cast<std::size_t>(state_.line)];
        line.low_m = glm::min(line.low_m, state_.at_m);
        line.high_m = glm::max(line.high_m, state_.at_m);
        if (is_over_water) lane().crossings.push_back({from, lane().line_m.size() - 1});
        if (!is_over_water && !state_.is_road && std::abs(length_m - kLaneStep_m) > 1.0e-3F)
            drawing_.lines[static_cast<std::size_t>(state_.line)].has_met = true;
    }

    const lsystem::Word& word_;
    Drawing drawing_;
    State state_;
    float lane_width_m_ = state_.width_m;
    std::vector<State> stack_;
};

struct Answer {
    enum Kind { Ends, GoesOn, Meets, Crosses };
    Kind kind = Ends;
    float turn_deg = 0, length_m = kLaneStep_m;
};

// Answers the ends of lanes, one after the other; each knows of those before.
class Surveyor {
  public:
    Surveyor(const scene::Land& land, const StreetRules& rules, base::Seed seed)
        : land_(land), rules_(rules), seed_(seed) {}

    void answer(lsystem::Word& word, int round) {
        drawing_ = Pen(word, rules_.width_m).drawn();
        begun_ = 0;
        for (const Drawing::Question& question : drawing_.questions) {
            float* asked = &word.values[word.symbols[question.symbol].first];
            const Answer given = answer_to(question, static_cast<int>(asked[3]), round);
            asked[0] = static_cast<float>(given.kind);
            asked[1] = given.turn_deg;
            asked[2] = given.length_m;
            if (given.kind == Answer::Ends) continue;
            if (question.line < 0) ++begun_;
            const glm::vec2 to = question.at_m + given.length_m * toward(question.heading_deg + given.turn_deg);
            walked_.push_back({question.at_m, to, question.line, question.from});
        }
        walked_.clear();
    }

  private:
    struct Walked {
        glm::vec2 from_m, to_m;
        int line, left;
    };

    Answer answer_to(const Drawing::Question& q, int goal, int round) {
        if (q.line < 0 && drawing_.lines.size() + begun_ >= kMostLanes) return {};
        if (glm::distance(q.at_m, rules_.middle_m) > kFarthest_m) return {};
        // Water that lies in the way is rather crossed than passed.
        if (surface_between(q.at_m, q.at_m + 2.5F * kLaneStep_m * toward(q.heading_deg)))
            if (const Answer over = crossing_from(q); over.kind == Answer::Crosses) return over;
        const std::optional<float> turn = best_turn(q, goal, round);
        if (!turn) return {};
        const glm::vec2 way = toward(q.heading_deg + *turn);
        const glm::vec2 to = q.at_m + kLaneStep_m * way;
        const glm::vec2 other = nearest_other(q, to);
        const float away_m = glm::distance(other, to);
        const glm::vec2 over = other - q.at_m;
        if (away_m < kMeets_m) {
            const float aside = turn_between(toward(q.heading_deg), over);
            const bool is_ahead = std::abs(aside) < 60 && glm::length(over) > 1;
            if (!is_ahead || points_of(q) < kOwnWay) return {};
            // Off by a little, so that the last step is known from the others.
            return {Answer::Meets, aside, std::max(glm::length(over), 0.5F) + 0.01F};
        }
        if (away_m < kApart_m && glm::dot(way, glm::normalize(over)) < 0.35F) return {};
        return {Answer::GoesOn, *turn, kLaneStep_m};
    }

    std::size_t points_of(const Drawing::Question& q) const {
        return q.line < 0 ? 1 : drawing_.lines[static_cast<std::size_t>(q.line)].branch.lane.line_m.size();
    }

    // The way that the pattern wants.
    glm::vec2 goal_of(const Drawing::Question& q, int goal) const {
        const glm::vec2 heading = toward(q.heading_deg);
        const glm::vec2 out = q.at_m - rules_.middle_m;
        if (goal == 0) {
            const float quarters = std::round((q.heading_deg - rules_.raster_deg) / 90);
            return toward(rules_.raster_deg + 90 * quarters);
        }
        if (goal == 3 || glm::length(out) < 12) return heading;
        const glm::vec2 ray = glm::normalize(out);
        const glm::vec2 wanted = goal == 1 ? glm::vec2{-ray.y, ray.x} : ray;
        return glm::dot(wanted, heading) < 0 ? -wanted : wanted;
    }

    std::optional<float> best_turn(const Drawing::Question& q, int goal, int round) const {
        const glm::vec2 wanted = goal_of(q, goal);
        const bool is_free = goal == 3;
        base::RandomStream random{seed_.child(static_cast<std::uint64_t>(round)).child(q.symbol)};
        const float drift_deg = 14 * rules_.winding * random.normal() * (is_free ? 0.5F : 0.25F);
        const float here_m = scene::ground_height_m(land_, q.at_m);
        std::optional<float> best;
        float least = std::numeric_limits<float>::max();
        for (int k = -4; k <= 4; ++k) {
            const float turn_deg = 6.5F * static_cast<float>(k) + drift_deg;
            const glm::vec2 way = toward(q.heading_deg + turn_deg);
            const glm::vec2 to = q.at_m + kLaneStep_m * way;
            const float climb = std::abs(scene::ground_height_m(land_, to) - here_m) / kLaneStep_m;
            if (climb > kSteepest || !is_buildable(land_, to) || !is_buildable(land_, to + 2 * kLaneStep_m * way))
                continue;
            const float astray = 1 - glm::dot(way, wanted);
            const float price = (1 + 3 * rules_.winding) * climb + 0.005F * std::abs(turn_deg - drift_deg) +
                                (is_free ? 0.35F : 3.0F) * astray;
            if (price >= least) continue;
            least = price;
            best = turn_deg;
        }
        return best;
    }

    // What a lane's end need not keep away from: itself, what has just left it, and, as long as it is young, what it
    // left and what begins where it does.
    struct Kin {
        int line, from;
        glm::vec2 began_m;
    };
    bool is_kin(const Kin& other, const Drawing::Question& q) const {
        if (q.line >= 0 && other.line == q.line) return true;
        if (q.line >= 0 && other.from == q.line && glm::distance(other.began_m, q.at_m) < kOwnWay * kLaneStep_m)
            return true;
        if (points_of(q) >= kOwnWay) return false;
        const Kin own = q.line < 0 ? Kin{-1, q.from, q.at_m} : kin_of(q.line);
        return (other.line >= 0 && other.line == own.from) || glm::distance(other.began_m, own.began_m) < 1;
    }
    Kin kin_of(int line) const {
        const Branch& branch = drawing_.lines[static_cast<std::size_t>(line)].branch;
        return {line, branch.from, branch.lane.line_m.front()};
    }

    // The nearest place of a line that this one need not touch, or far away.
    glm::vec2 nearest_other(const Drawing::Question& q, glm::vec2 to) const {
        glm::vec2 nearest = to + 1.0e6F;
        const auto look = [&](glm::vec2 a, glm::vec2 b) {
            const glm::vec2 d = b - a;
            const float along = std::clamp(glm::dot(to - a, d) / std::max(glm::dot(d, d), 1.0e-6F), 0.0F, 1.0F);
            const glm::vec2 place = a + along * d;
            if (glm::distance(place, to) < glm::distance(nearest, to)) nearest = place;
        };
        for (std::size_t i = 0; i < drawing_.lines.size(); ++i) {
            if (is_kin(kin_of(static_cast<int>(i)), q)) continue;
            if (!drawing_.lines[i].is_near(to, kApart_m)) continue;
            const std::vector<glm::vec2>& line = drawing_.lines[i].branch.lane.line_m;
            for (std::size_t k = 0; k + 1 < line.size(); ++k) look(line[k], line[k + 1]);
        }
        for (const Walked& walked : walked_) {
            const Kin kin = walked.line < 0 ? Kin{-1, walked.left, walked.from_m} : kin_of(walked.line);
            if (!is_kin(kin, q)) look(walked.from_m, walked.to_m);
        }
        return nearest;
    }

    // Straight over narrow water, from one bank to about as high a one.
    Answer crossing_from(const Drawing::Question& q) {
        if (points_of(q) < 2 || crossings_.size() >= kMostCrossings) return {};
        for (const glm::vec2 other : crossings_)
            if (glm::distance(other, q.at_m) < kCrossingsApart_m) return {};
        const float here_m = scene::ground_height_m(land_, q.at_m);
        for (float length_m = 2 * kLaneStep_m; length_m <= kWidest_m; length_m += kLaneStep_m)
            for (const float turn_deg : {0.0F, 10.0F, -10.0F, 22.0F, -22.0F}) {
                const glm::vec2 way = toward(q.heading_deg + turn_deg);
                const glm::vec2 to = q.at_m + length_m * way;
                if (!is_buildable(land_, to) || !is_buildable(land_, to + kLaneStep_m * way)) continue;
                if (std::abs(scene::ground_height_m(land_, to) - here_m) > 2.2F) continue;
                const std::optional<float> surface_m = surface_between(q.at_m, to);
                if (!surface_m || here_m - *surface_m > kOverWater_m) continue;
                if (glm::distance(nearest_other(q, to), to) < kApart_m) continue;
                crossings_.push_back(q.at_m);
                return {Answer::Crosses, turn_deg, length_m};
            }
        return {};
    }

    // Of the first water on the way.
    std::optional<float> surface_between(glm::vec2 from, glm::vec2 to) const {
        for (int i = 1; i < 16; ++i) {
            const glm::vec2 at = from + (to - from) * (static_cast<float>(i) / 16);
            if (scene::water_depth_m(land_, at) > 0) return scene::water_surface_m(land_, at);
        }
        return std::nullopt;
    }

    const scene::Land& land_;
    const StreetRules& rules_;
    base::Seed seed_;
    Drawing drawing_;
    std::size_t begun_ = 0;
    std::vector<Walked> walked_;
    std::vector<glm::vec2> crossings_;
};

std::vector<Branch> worth_walking(std::vector<Drawing::Line> lines) {
    std::vector<bool> is_kept(lines.size(), false);
    for (std::size_t i = lines.size(); i-- > 0;) {
        const Lane& lane = lines[i].branch.lane;
        const float length_m = kLaneStep_m * static_cast<float>(lane.line_m.size() - 1);
        is_kept[i] = is_kept[i] || lane.is_road || lines[i].has_met || length_m >= kShortest_m;
        if (is_kept[i] && lines[i].branch.from >= 0) is_kept[static_cast<std::size_t>(lines[i].branch.from)] = true;
    }
    std::vector<int> number(lines.size(), -1);
    std::vector<Branch> kept;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!is_kept[i]) continue;
        number[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(lines[i].branch));
        if (kept.back().from >= 0) kept.back().from = number[static_cast<std::size_t>(kept.back().from)];
    }
    return kept;
}

}  // namespace

std::vector<Branch> grow_streets(const scene::Land& land, const StreetRules& rules, const lsystem::Word& beginning,
                                 base::Seed seed) {
    lsystem::Grammar grammar = grammar_of(rules.pattern);
    grammar.axiom = beginning;
    Surveyor surveyor(land, rules, seed.child("survey"));
    for (int round = 0; round < kMostSteps; ++round) {
        surveyor.answer(grammar.axiom, round);
        lsystem::Word next =
            lsystem::derive(grammar, {1, seed.child(static_cast<std::uint64_t>(round)), std::size_t{1} << 18U}).word;
        const bool asks = std::ranges::any_of(next.symbols, [](const auto& s) { return s.letter == '?'; });
        grammar.axiom = std::move(next);
        if (!asks) break;
    }
    return worth_walking(Pen(grammar.axiom, rules.width_m).drawn().lines);
}

}  // namespace quadrat::synthesis::houses
