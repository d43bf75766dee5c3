// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/houses/masses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kStep_m = 3.2F;
constexpr float kSteepest = 0.42F;         // along them
constexpr int kFewestPieces = 3;           // of a run
constexpr std::size_t kMostPieces = 1400;  // of all hedges, walls and fences, kStep_m each

enum class Kind { Hedge, Wall, Fence };

struct Bound {
    Kind kind = Kind::Hedge;
    float height_m = 1.1F;
    glm::vec3 colour{0.05F, 0.09F, 0.03F};
};

class Bounds {
  public:
    Bounds(const scene::Land& land, const Settled& settled, const scene::LandParameters& p)
        : land_(land), settled_(settled), region_(std::clamp(static_cast<int>(std::lround(p.settle_region)), 0, 5)) {}

    // By region: alpine fences, nordic fences, mediterranean walls, savanna thorn hedges, hedges, dry walls.
    Bound bound_of(base::RandomStream& random) const {
        constexpr std::array<std::array<Kind, 2>, 6> kKinds{{{Kind::Fence, Kind::Hedge},
                                                             {Kind::Fence, Kind::Fence},
                                                             {Kind::Wall, Kind::Wall},
                                                             {Kind::Hedge, Kind::Fence},
                                                             {Kind::Hedge, Kind::Fence},
                                                             {Kind::Wall, Kind::Hedge}}};
        Bound bound;
        bound.kind = kKinds[static_cast<std::size_t>(region_)][random.unit_f() < 0.7F ? 0 : 1];
        const float light = random.between(0.85F, 1.15F);
        if (bound.kind == Kind::Hedge) {
            bound.height_m = random.between(0.8F, 1.25F);
            bound.colour = light * scene::linear_from_srgb_hex(region_ == 3 ? 0x6E6A45 : 0x4A6234);
        } else if (bound.kind == Kind::Wall) {
            bound.height_m = random.between(0.7F, 1.0F);
            bound.colour = light * scene::linear_from_srgb_hex(region_ == 2 ? 0xB8A98B : 0x8B877E);
        } else {
            bound.height_m = 1.0F;
            bound.colour =
                light * scene::linear_from_srgb_hex(region_ == 1 && random.unit_f() < 0.5F ? 0xD8D6CE : 0x7B6A55);
        }
        return bound;
    }

    void add_line(scene::Masses& to, glm::vec2 from, glm::vec2 end, const Bound& bound, const scene::House* own) {
        const float length = glm::distance(from, end);
        const int steps = std::max(1, static_cast<int>(std::lround(length / kStep_m)));
        look_about(0.5F * (from + end), 0.5F * length);
        const auto at = [&](int i) { return glm::mix(from, end, static_cast<float>(i) / static_cast<float>(steps)); };
        int first = 0;
        for (int i = 0; i <= steps; ++i) {
            if (i < steps && has_room(at(i), at(i + 1), own)) continue;
            // A piece or two alone enclose nothing.
            if (i - first >= std::min(kFewestPieces, steps))
                for (int k = first; k < i && pieces_ < kMostPieces; ++k, ++pieces_) {
                    own_.push_back(0.5F * (at(k) + at(k + 1)));
                    add_piece(to, at(k), at(k + 1), bound, k > first);
                }
            first = i + 1;
        }
    }

    // A plot is whole: the next one keeps away from its bounds.
    void end_plot() {
        others_.insert(others_.end(), own_.begin(), own_.end());
        own_.clear();
    }

  private:
    bool has_room(glm::vec2 a, glm::vec2 b, const scene::House* own) const {
        const glm::vec2 middle = 0.5F * (a + b);
        if (!is_free(a, own) || !is_free(b, own) || !is_free(middle, own) || is_bounded(middle)) return false;
        const float climb_m = scene::ground_height_m(land_, b) - scene::ground_height_m(land_, a);
        return std::abs(climb_m) <= kSteepest * glm::distance(a, b);
    }

    bool is_bounded(glm::vec2 at) const {
        return std::ranges::any_of(others_, [at](glm::vec2 p) { return glm::distance(p, at) < 3.4F; });
    }

    struct Segment {
        glm::vec2 from_m, way_m;
        float room_m;
    };

    // The roads and houses that a line of this reach about a place may meet.
    void look_about(glm::vec2 middle, float reach_m) {
        segments_.clear();
        houses_.clear();
        for (const scene::Road& road : land_.roads)
            for (std::size_t i = 0; i + 1 < road.line_m.size(); ++i) {
                const glm::vec2 from{road.line_m[i].x, road.line_m[i].z};
                const glm::vec2 way = glm::vec2{road.line_m[i + 1].x, road.line_m[i + 1].z} - from;
                const float room_m = 0.5F * road.width_m + 0.5F;
                const float near_m = reach_m + room_m + glm::length(way);
                const glm::vec2 d = from - middle;
                if (glm::dot(d, d) < near_m * near_m) segments_.push_back({from, way, room_m});
            }
        for (const scene::House& house : settled_.settlement.houses) {
            const glm::vec2 d{house.foot_m.x - middle.x, house.foot_m.z - middle.y};
            if (glm::dot(d, d) < (reach_m + 20) * (reach_m + 20)) houses_.push_back(&house);
        }
    }

    bool is_free(glm::vec2 at, const scene::House* own) const {
        if (!is_buildable(land_, at)) return false;
        for (const Segment& segment : segments_) {
            const glm::vec2 d = segment.way_m;
            const float t = std::clamp(glm::dot(at - segment.from_m, d) / std::max(glm::dot(d, d), 1e-6F), 0.0F, 1.0F);
            if (glm::distance(at, segment.from_m + t * d) < segment.room_m) return false;
        }
        return std::ranges::all_of(houses_, [&](const scene::House* house) {
            const glm::vec2 d{house->foot_m.x - at.x, house->foot_m.z - at.y};
            if (glm::dot(d, d) > 400) return true;
            const float room_m = house == own ? 0.2F : 1.6F;
            return scene::to_house_m(settled_.settlement.buildings[house->building], *house, at) > room_m;
        });
    }

    glm::vec3 on_ground(glm::vec2 p, float over_m) const {
        return {p.x, scene::ground_height_m(land_, p) + over_m, p.y};
    }

    // Half its width, and how high, from foot to crown; a wall is even, a hedge grows as it likes.
    struct Rib {
        std::array<float, 3> half_m, over_m;
    };
    Rib rib_at(glm::vec2 p, const Bound& bound) const {
        const float h = bound.height_m;
        if (bound.kind == Kind::Wall) return {{0.26F, 0.24F, 0.22F}, {-0.3F, 0.5F * h, h}};
        const auto place = [](float m) { return static_cast<std::int64_t>(std::floor(4 * m)); };
        const std::uint64_t grown = base::hash_of(base::Seed{7}, place(p.x), place(p.y));
        const float wide = 0.82F + 0.36F * base::unit_of(grown);
        const float high = 0.80F + 0.40F * base::unit_of(grown * 0x9E3779B97F4A7C15ULL);
        return {{0.42F * wide, 0.56F * wide, 0.30F * wide}, {-0.3F, 0.55F * h * high, h * high}};
    }

    void add_piece(scene::Masses& to, glm::vec2 a, glm::vec2 b, const Bound& bound, bool is_joined) const {
        if (bound.kind == Kind::Fence) return add_fence(to, a, b, bound);
        const glm::vec2 d = glm::normalize(b - a);
        const glm::vec2 side{-d.y, d.x};
        const bool is_hedge = bound.kind == Kind::Hedge;
        const Look look{bound.colour, is_hedge ? scene::Cladding::Leaves : scene::Cladding::Rubble, 0};
        const Rib at_a = rib_at(a, bound);
        const Rib at_b = rib_at(b, bound);
        const std::size_t first = is_hedge ? 0 : 1;  // a wall is as wide below as in its middle
        constexpr std::array<float, 3> kLight{0.5F, 0.86F, 1.1F};
        const auto on = [&](glm::vec2 p, const Rib& rib, std::size_t k, float s) {
            return on_ground(p + s * rib.half_m[k] * side, k == first ? -0.3F : rib.over_m[k]);
        };
        for (std::size_t k = first; k < 2; ++k)
            for (const float s : {1.0F, -1.0F}) {
                const auto& [p, p_rib, q, q_rib] = s > 0 ? std::tie(a, at_a, b, at_b) : std::tie(b, at_b, a, at_a);
                const std::array<float, 4> shades{kLight[k], kLight[k], kLight[k + 1], kLight[k + 1]};
                add_face(
                    to,
                    std::array{on(p, p_rib, k, s), on(q, q_rib, k, s), on(q, q_rib, k + 1, s), on(p, p_rib, k + 1, s)},
                    look, shades);
            }
        const bool is_snowy = scene::ground_height_m(land_, a) > land_.snow_line_m;
        const Look top = is_snowy ? Look{kSnow, scene::Cladding::Plain, 0} : Look{1.1F * look.colour, look.cladding, 0};
        add_face(to, std::array{on(a, at_a, 2, 1), on(b, at_b, 2, 1), on(b, at_b, 2, -1), on(a, at_a, 2, -1)}, top);
        for (const float s : {1.0F, -1.0F}) {
            if (s > 0 && is_joined) continue;
            const glm::vec2 end = s > 0 ? a : b;
            const Rib& rib = s > 0 ? at_a : at_b;
            std::vector<glm::vec3> corners;
            std::vector<float> shades;
            const auto add = [&](std::size_t k, float side_of) {
                corners.push_back(on(end, rib, k, side_of));
                shades.push_back(kLight[k]);
            };
            for (std::size_t k = first; k < 3; ++k) add(k, s);
            for (std::size_t k = 3; k-- > first;) add(k, -s);
            add_face(to, corners, look, shades);
        }
    }

    // Two rails and a post, seen from both sides.
    void add_fence(scene::Masses& to, glm::vec2 a, glm::vec2 b, const Bound& bound) const {
        const Look look{bound.colour, scene::Cladding::Plain, 0};
        const auto plank = [&](float low, float high) {
            add_face(to, std::array{on_ground(a, low), on_ground(b, low), on_ground(b, high), on_ground(a, high)},
                     look);
            add_face(to, std::array{on_ground(b, low), on_ground(a, low), on_ground(a, high), on_ground(b, high)},
                     look);
        };
        plank(0.35F, 0.48F);
        plank(0.78F, 0.92F);
        const glm::vec2 d = glm::normalize(b - a);
        add_box(to, {on_ground(a, -0.3F), {d.x, 0, d.y}, {0.07F, bound.height_m + 0.35F, 0.07F}}, look);
    }

    const scene::Land& land_;
    const Settled& settled_;
    int region_;
    std::size_t pieces_ = 0;
    std::vector<glm::vec2> own_, others_;  // the middles of pieces
    std::vector<Segment> segments_;        // that the line in hand may meet
    std::vector<const scene::House*> houses_;
};

}  // namespace

std::vector<scene::Masses> add_bounds(const scene::Land& land, const Settled& settled,
                                      const std::vector<scene::FieldPlot>& fields,
                                      const scene::LandParameters& parameters, base::Seed seed) {
    std::vector<scene::Masses> all;
    Bounds bounds(land, settled, parameters);
    const scene::Settlement& settlement = settled.settlement;
    for (std::size_t i = 0; i < settlement.houses.size(); ++i) {
        base::RandomStream random{seed.child("garden").child(i)};
        const Bound bound = bounds.bound_of(random);
        if (random.unit_f() > parameters.settle_hedges) continue;
        const scene::House& house = settlement.houses[i];
        const glm::vec2 half = settlement.buildings[house.building].half_m;
        const float back_m = half.y + random.between(5.0F, 7.0F + 9.0F * parameters.settle_gardens);
        const float wide_m = half.x + random.between(1.2F, 2.0F + 6.0F * parameters.settle_gardens);
        const auto at = [&](float x, float z) {
            const glm::vec3 p = scene::placed(house, {x, 0, z});
            return glm::vec2{p.x, p.z};
        };
        scene::Masses piece;
        const float front_m = half.y + random.between(0.2F, 1.6F);
        bounds.add_line(piece, at(-wide_m, front_m), at(-wide_m, -back_m), bound, &house);
        bounds.add_line(piece, at(-wide_m, -back_m), at(wide_m, -back_m), bound, &house);
        bounds.add_line(piece, at(wide_m, -back_m), at(wide_m, front_m), bound, &house);
        bounds.end_plot();
        if (!piece.mesh.indices.empty()) all.push_back(std::move(piece));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].has_hedge) continue;
        base::RandomStream random{seed.child("field").child(i)};
        const Bound bound = bounds.bound_of(random);
        scene::Masses piece;
        const auto& outline = fields[i].outline_m;
        for (std::size_t k = 0; k < outline.size(); ++k)
            bounds.add_line(piece, outline[k], outline[(k + 1) % outline.size()], bound, nullptr);
        bounds.end_plot();
        if (!piece.mesh.indices.empty()) all.push_back(std::move(piece));
    }
    return all;
}

}  // namespace quadrat::synthesis::houses
