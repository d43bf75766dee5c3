// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"
#include "synthesis/houses/masses.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kStep_m = 3.2F;
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
        for (int i = 0; i < steps && pieces_ < kMostPieces; ++i) {
            const float n = static_cast<float>(steps);
            const glm::vec2 a = from + (end - from) * (static_cast<float>(i) / n);
            const glm::vec2 b = from + (end - from) * (static_cast<float>(i + 1) / n);
            if (!is_free(a, own) || !is_free(b, own) || !is_free(0.5F * (a + b), own)) continue;
            if (is_bounded(0.5F * (a + b))) continue;
            own_.push_back(0.5F * (a + b));
            add_piece(to, a, b, bound);
            ++pieces_;
        }
    }

    // A plot is whole: the next one keeps away from its bounds.
    void end_plot() {
        others_.insert(others_.end(), own_.begin(), own_.end());
        own_.clear();
    }

  private:
    bool is_bounded(glm::vec2 at) const {
        return std::ranges::any_of(others_, [at](glm::vec2 p) { return glm::distance(p, at) < 3.4F; });
    }

    bool is_free(glm::vec2 at, const scene::House* own) const {
        if (!is_buildable(land_, at)) return false;
        for (const scene::Road& road : land_.roads)
            for (std::size_t i = 0; i + 1 < road.line_m.size(); ++i) {
                const glm::vec2 a{road.line_m[i].x, road.line_m[i].z};
                const glm::vec2 d = glm::vec2{road.line_m[i + 1].x, road.line_m[i + 1].z} - a;
                if (glm::distance(a, at) > 30) continue;
                const float t = std::clamp(glm::dot(at - a, d) / std::max(glm::dot(d, d), 1e-6F), 0.0F, 1.0F);
                if (glm::distance(at, a + t * d) < 0.5F * road.width_m + 0.5F) return false;
            }
        return std::ranges::all_of(settled_.settlement.houses, [&](const scene::House& house) {
            const glm::vec2 d{house.foot_m.x - at.x, house.foot_m.z - at.y};
            if (glm::dot(d, d) > 400) return true;
            const float room_m = &house == own ? 0.2F : 1.6F;
            return scene::to_house_m(settled_.settlement.buildings[house.building], house, at) > room_m;
        });
    }

    glm::vec3 on_ground(glm::vec2 p, float over_m) const {
        return {p.x, scene::ground_height_m(land_, p) + over_m, p.y};
    }

    void add_piece(scene::Masses& to, glm::vec2 a, glm::vec2 b, const Bound& bound) const {
        const glm::vec2 d = glm::normalize(b - a);
        const glm::vec2 side{-d.y, d.x};
        if (bound.kind == Kind::Fence) return add_fence(to, a, b, bound);
        const float half = bound.kind == Kind::Hedge ? 0.45F : 0.26F;
        const float top = bound.kind == Kind::Hedge ? 0.28F : 0.22F;
        const Look look{bound.colour, bound.kind == Kind::Hedge ? scene::Cladding::Thatch : scene::Cladding::Rubble, 0};
        const std::array<float, 4> shades{0.6F, 0.6F, 1, 1};
        for (const float s : {1.0F, -1.0F}) {
            const glm::vec2 p = s > 0 ? a : b;
            const glm::vec2 q = s > 0 ? b : a;
            add_face(to,
                     std::array{on_ground(p + s * half * side, -0.3F), on_ground(q + s * half * side, -0.3F),
                                on_ground(q + s * top * side, bound.height_m),
                                on_ground(p + s * top * side, bound.height_m)},
                     look, shades);
        }
        add_face(to,
                 std::array{on_ground(a + top * side, bound.height_m), on_ground(b + top * side, bound.height_m),
                            on_ground(b - top * side, bound.height_m), on_ground(a - top * side, bound.height_m)},
                 {1.12F * look.colour, look.cladding, 0});
        for (const glm::vec2 end : {a, b}) {
            const float s = end == a ? 1.0F : -1.0F;
            add_face(to,
                     std::array{on_ground(end - s * half * side, -0.3F), on_ground(end + s * half * side, -0.3F),
                                on_ground(end + s * top * side, bound.height_m),
                                on_ground(end - s * top * side, bound.height_m)},
                     look, shades);
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
};

}  // namespace

std::vector<scene::Masses> add_bounds(const scene::Land& land, const Settled& settled,
                                      const std::vector<FieldPlot>& fields, const scene::LandParameters& parameters,
                                      base::Seed seed) {
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
            if (random.unit_f() < 0.75F)
                bounds.add_line(piece, outline[k], outline[(k + 1) % outline.size()], bound, nullptr);
        bounds.end_plot();
        if (!piece.mesh.indices.empty()) all.push_back(std::move(piece));
    }
    return all;
}

}  // namespace quadrat::synthesis::houses
