// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/bridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/seed.hpp"
#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/houses/masses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kReach_m = 240;    // of roads, beyond the outermost house
constexpr float kLongest_m = 45;   // of a bridge
constexpr float kOnBank_m = 3.2F;  // a bridge's ends lie on dry land
constexpr float kParapet_m = 0.75F;
constexpr float kUnderDeck_m = 0.45F;
constexpr float kSound_m = 0.5F;  // from place to place where water is looked for
constexpr int kPieces = 12;       // of an arch

class Line {
  public:
    explicit Line(const std::vector<glm::vec2>& points) : points_(points) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) length_m_ += glm::distance(points[i], points[i + 1]);
    }
    float length_m() const { return length_m_; }
    glm::vec2 at(float along_m) const {
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
            const float step_m = glm::distance(points_[i], points_[i + 1]);
            if (along_m <= step_m)
                return points_[i] + (points_[i + 1] - points_[i]) * (along_m / std::max(step_m, 1e-6F));
            along_m -= step_m;
        }
        return points_.back();
    }

  private:
    const std::vector<glm::vec2>& points_;
    float length_m_ = 0;
};

void add_spans(const scene::Land& land, const std::vector<glm::vec2>& points, float width_m, std::vector<Span>& to) {
    const Line line(points);
    Span span;
    float from_m = -1;  // of the water; -1: none yet
    float to_m = 0;
    const auto end_span = [&] {
        const bool has_banks = from_m > kSound_m && line.length_m() - to_m > kSound_m;
        span.from_m = line.at(std::max(from_m - kOnBank_m, 0.0F));
        span.to_m = line.at(std::min(to_m + kOnBank_m, line.length_m()));
        if (has_banks && glm::distance(span.from_m, span.to_m) < kLongest_m) to.push_back(span);
        from_m = -1;
    };
    for (float along_m = 0; along_m < line.length_m(); along_m += kSound_m) {
        const glm::vec2 at = line.at(along_m);
        const float depth_m = scene::water_depth_m(land, at);
        if (depth_m > 0) {
            if (from_m < 0) {
                from_m = along_m;
                span = {{}, {}, width_m, 0, scene::water_surface_m(land, at)};
            }
            to_m = along_m;
            span.deepest_m = std::max(span.deepest_m, depth_m);
        } else if (from_m >= 0 && along_m - to_m > 2 * kOnBank_m) {
            end_span();
        }
    }
    if (from_m >= 0) end_span();
}

// A bridge's line from bank to bank, and what stands across it.
class Bridge {
  public:
    Bridge(const scene::Land& land, const Span& span)
        : span_(span),
          from_m_(land_height(land, span.from_m)),
          to_m_(land_height(land, span.to_m)),
          length_m_(glm::distance(span.from_m, span.to_m)),
          along_((span.to_m - span.from_m) / length_m_),
          across_(-along_.y, along_.x) {
        camber_m_ = std::max(0.07F * length_m_, span.surface_m + 1.0F - 0.5F * (from_m_ + to_m_));
    }

    // The deck: t 0 to 1 from bank to bank.
    float deck_m(float t) const {
        const float s = 2 * t - 1;
        return from_m_ + t * (to_m_ - from_m_) + camber_m_ * (1 - s * s) + 0.06F;
    }
    glm::vec3 at(float t, float aside_m, float height_m) const {
        const glm::vec2 p = span_.from_m + t * length_m_ * along_ + aside_m * across_;
        return {p.x, height_m, p.y};
    }
    // The arch's underside; down to the bed at its feet.
    float arch_m(float t) const {
        const float s = std::clamp((2 * t - 1) / 0.86F, -1.0F, 1.0F);
        const float foot_m = span_.surface_m - span_.deepest_m - 0.6F;
        const float crown_m = deck_m(0.5F) - kUnderDeck_m;
        return foot_m + (crown_m - foot_m) * std::sqrt(std::max(0.0F, 1 - s * s));
    }
    float half_m() const { return 0.5F * span_.width_m + 0.25F; }
    float length_m() const { return length_m_; }
    glm::vec2 along() const { return along_; }
    static float share(int i) { return static_cast<float>(i) / kPieces; }

  private:
    static float land_height(const scene::Land& land, glm::vec2 at) { return scene::ground_height_m(land, at); }
    const Span& span_;
    float from_m_, to_m_, length_m_;
    glm::vec2 along_, across_;
    float camber_m_ = 0;
};

void add_two_sided(scene::Masses& to, const std::array<glm::vec3, 4>& corners, const Look& look) {
    add_face(to, corners, look);
    add_face(to, std::array{corners[3], corners[2], corners[1], corners[0]}, look);
}

void add_stone(scene::Masses& to, const Bridge& bridge) {
    const Look stone{scene::linear_from_srgb_hex(0x8F887C), scene::Cladding::Rubble, 0};
    const Look cap{scene::linear_from_srgb_hex(0xA39B8D), scene::Cladding::Plain, 0};
    const Look deck{scene::linear_from_srgb_hex(0x857A66), scene::Cladding::Plaster, 0};
    const Look under{0.45F * stone.colour, scene::Cladding::Rubble, 0};
    const float h = bridge.half_m();
    constexpr float kThick_m = 0.28F;
    for (int i = 0; i < kPieces; ++i) {
        const float t = Bridge::share(i);
        const float u = Bridge::share(i + 1);
        const float lo_t = bridge.arch_m(t);
        const float lo_u = bridge.arch_m(u);
        const float hi_t = bridge.deck_m(t) + kParapet_m;
        const float hi_u = bridge.deck_m(u) + kParapet_m;
        const auto at = [&](float s, float aside, float y) { return bridge.at(s, aside, y); };
        // The flanks, from the arch to the parapet's top.
        add_face(to, std::array{at(t, h, lo_t), at(u, h, lo_u), at(u, h, hi_u), at(t, h, hi_t)}, stone);
        add_face(to, std::array{at(u, -h, lo_u), at(t, -h, lo_t), at(t, -h, hi_t), at(u, -h, hi_u)}, stone);
        add_face(to, std::array{at(t, -h, lo_t), at(u, -h, lo_u), at(u, h, lo_u), at(t, h, lo_t)}, under);
        const float in = h - kThick_m;
        const float d_t = bridge.deck_m(t);
        const float d_u = bridge.deck_m(u);
        add_face(to, std::array{at(t, in, d_t), at(u, in, d_u), at(u, -in, d_u), at(t, -in, d_t)}, deck);
        add_face(to, std::array{at(u, in, d_u), at(t, in, d_t), at(t, in, hi_t), at(u, in, hi_u)}, stone);
        add_face(to, std::array{at(t, -in, d_t), at(u, -in, d_u), at(u, -in, hi_u), at(t, -in, hi_t)}, stone);
        add_face(to, std::array{at(t, h, hi_t), at(u, h, hi_u), at(u, in, hi_u), at(t, in, hi_t)}, cap);
        add_face(to, std::array{at(t, -in, hi_t), at(u, -in, hi_u), at(u, -h, hi_u), at(t, -h, hi_t)}, cap);
    }
    for (const float end : {0.0F, 1.0F})
        for (const float side : {h - 0.5F * kThick_m, -h + 0.5F * kThick_m}) {
            const glm::vec3 foot = bridge.at(end, side, bridge.deck_m(end) - 1.2F);
            add_box(to, {foot, {bridge.along().x, 0, bridge.along().y}, {0.24F, 1.2F + kParapet_m + 0.12F, 0.24F}},
                    stone);
        }
}

// Two bent beams under planks, rails on posts.
void add_wooden(scene::Masses& to, const Bridge& bridge) {
    const Look planks{scene::linear_from_srgb_hex(0x8B7A63), scene::Cladding::Planks, 0};
    const Look beam{scene::linear_from_srgb_hex(0x5A4B3A), scene::Cladding::Plain, 0};
    const float h = bridge.half_m();
    for (int i = 0; i < kPieces; ++i) {
        const float t = Bridge::share(i);
        const float u = Bridge::share(i + 1);
        const auto at = [&](float s, float aside, float over) { return bridge.at(s, aside, bridge.deck_m(s) + over); };
        add_face(to, std::array{at(t, h, 0), at(u, h, 0), at(u, -h, 0), at(t, -h, 0)}, planks);
        add_face(to, std::array{at(t, -h, -0.12F), at(u, -h, -0.12F), at(u, h, -0.12F), at(t, h, -0.12F)},
                 {0.4F * planks.colour, scene::Cladding::Plain, 0});
        for (const float side : {h, -h}) {
            add_two_sided(to, {at(t, side, -0.42F), at(u, side, -0.42F), at(u, side, 0.02F), at(t, side, 0.02F)}, beam);
            add_two_sided(to, {at(t, side, 0.82F), at(u, side, 0.82F), at(u, side, 0.94F), at(t, side, 0.94F)}, beam);
            add_two_sided(to, {at(t, side, 0.42F), at(u, side, 0.42F), at(u, side, 0.5F), at(t, side, 0.5F)}, beam);
        }
    }
    const int posts = std::max(2, static_cast<int>(bridge.length_m() / 2));
    for (int i = 0; i <= posts; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(posts);
        for (const float side : {h, -h}) {
            const glm::vec3 foot = bridge.at(t, side, bridge.deck_m(t) - 0.4F);
            add_box(to, {foot, {bridge.along().x, 0, bridge.along().y}, {0.06F, 1.42F, 0.06F}}, beam);
        }
        const bool is_inner = i > 0 && i < posts && i % 2 == 0;
        if (!is_inner) continue;
        for (const float side : {0.7F * h, -0.7F * h}) {  // piles
            const float low_m = bridge.arch_m(0) - 0.5F;
            const glm::vec3 foot = bridge.at(t, side, low_m);
            add_box(to,
                    {foot, {bridge.along().x, 0, bridge.along().y}, {0.11F, bridge.deck_m(t) - 0.1F - low_m, 0.11F}},
                    beam);
        }
    }
}

// Stepping stones at the lower side of the way.
void add_ford(scene::Masses& to, const scene::Land& land, const Span& span) {
    const float length_m = glm::distance(span.from_m, span.to_m);
    const glm::vec2 along = (span.to_m - span.from_m) / length_m;
    const glm::vec2 across{-along.y, along.x};
    const Look stone{scene::linear_from_srgb_hex(0x97918A), scene::Cladding::Plaster, 0};
    const base::Seed seed{0xF02D};
    const int count = std::max(2, static_cast<int>(length_m / 0.75F));
    for (int i = 0; i <= count; ++i) {
        const auto chance = [&](int k) {
            return base::unit_of(base::hash_of(seed, i, k, static_cast<std::int64_t>(span.from_m.x * 8)));
        };
        const glm::vec2 at = span.from_m + along * (length_m * static_cast<float>(i) / static_cast<float>(count)) +
                             across * (0.5F * span.width_m + 0.2F * chance(0));
        const float bed_m = scene::ground_height_m(land, at);
        const float top_m = std::max(span.surface_m + 0.08F + 0.08F * chance(1), bed_m + 0.06F);
        const float turn = chance(2) * 1.6F;
        add_box(to,
                {{at.x, bed_m - 0.4F, at.y},
                 {std::cos(turn), 0, std::sin(turn)},
                 {0.22F + 0.1F * chance(3), top_m - bed_m + 0.4F, 0.2F + 0.1F * chance(4)}},
                stone, 0.7F);
    }
}

}  // namespace

std::vector<Span> spans_of(const scene::Land& land, const Settled& settled) {
    std::vector<Span> spans;
    for (const scene::Road& road : land.roads) {
        if (road.is_lane) continue;
        std::vector<glm::vec2> near;
        for (const glm::vec3& p : road.line_m)
            if (glm::distance(glm::vec2{p.x, p.z}, settled.middle_m) < settled.reach_m + kReach_m)
                near.emplace_back(p.x, p.z);
        add_spans(land, near, road.width_m, spans);
    }
    for (const Lane& lane : settled.lanes)
        for (const Lane::Crossing& crossing : lane.crossings)
            if (crossing.to < lane.line_m.size()) {
                const std::size_t from = crossing.from - std::min<std::size_t>(crossing.from, 1);
                const std::size_t to = std::min(crossing.to + 2, lane.line_m.size());
                add_spans(land,
                          {lane.line_m.begin() + static_cast<std::ptrdiff_t>(from),
                           lane.line_m.begin() + static_cast<std::ptrdiff_t>(to)},
                          lane.width_m, spans);
            }
    return spans;
}

std::vector<scene::Masses> add_bridges(const scene::Land& land, const Settled& settled,
                                       const scene::LandParameters& parameters) {
    const auto region = std::lround(parameters.settle_region);
    const bool is_wooden = region == 0 || region == 1 || region == 3;
    std::vector<scene::Masses> all;
    for (const Span& span : spans_of(land, settled)) {
        scene::Masses piece;
        if (span.deepest_m <= kFord_m)
            add_ford(piece, land, span);
        else if (is_wooden)
            add_wooden(piece, Bridge(land, span));
        else
            add_stone(piece, Bridge(land, span));
        all.push_back(std::move(piece));
    }
    return all;
}

}  // namespace quadrat::synthesis::houses
