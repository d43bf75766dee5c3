// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/lots.hpp"
#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/houses/lanes.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr float kSteepest = 0.17F;
constexpr float kMost_m = 250;  // from the middle

struct Look {
    std::uint32_t colour;
    float rows;
};
// By scene::Crop.
constexpr std::array<Look, scene::kCrops> kLooks{{{0x6F8A42, 0.0F},
                                                  {0x8FA257, 0.25F},
                                                  {0x7C9A4A, 0.35F},
                                                  {0xC9B260, 0.2F},
                                                  {0xBCA777, 0.4F},
                                                  {0x7D6549, 0.55F},
                                                  {0x5F7F45, 0.6F}}};

glm::vec3 srgb_of(std::uint32_t rgb) {
    return glm::vec3{static_cast<float>(rgb >> 16U), static_cast<float>(rgb >> 8U & 255U),
                     static_cast<float>(rgb & 255U)} /
           255.0F;
}

class Tillage {
  public:
    Tillage(const scene::Land& land, const Settled& settled) : land_(land), settled_(settled) {}

    bool is_fit(const std::vector<glm::vec2>& outline) const {
        glm::vec2 middle{0};
        for (const glm::vec2 p : outline) middle += p / static_cast<float>(outline.size());
        if (glm::distance(middle, settled_.middle_m) > kMost_m) return false;
        int bad = 0;
        for (const glm::vec2 p : outline) {
            const glm::vec2 inside = p + 0.2F * (middle - p);
            if (!is_fit_at(inside) || !is_fit_at(0.5F * (inside + middle))) ++bad;
        }
        return bad == 0 && is_fit_at(middle) && is_dry(outline, middle);
    }

  private:
    // No brook runs through it, from corner to corner or side to side.
    bool is_dry(const std::vector<glm::vec2>& outline, glm::vec2 middle) const {
        constexpr float kApart_m = 4;  // narrower ones are rills
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::vec2 next = outline[(i + 1) % outline.size()];
            const int rays = std::max(1, static_cast<int>(glm::distance(outline[i], next) / 12));
            for (int k = 0; k < rays; ++k) {
                const glm::vec2 rim =
                    outline[i] + (static_cast<float>(k) / static_cast<float>(rays)) * (next - outline[i]);
                const float far_m = glm::distance(rim, middle);
                for (float m = 0; m < far_m; m += kApart_m)
                    if (scene::water_depth_m(land_, rim + (m / far_m) * (middle - rim)) > 0) return false;
            }
        }
        return true;
    }

    bool is_fit_at(glm::vec2 p) const {
        if (!is_buildable(land_, p) || steepness(land_, p, 7) > kSteepest) return false;
        for (const scene::Road& road : land_.roads)
            for (const glm::vec3& r : road.line_m) {
                const glm::vec2 d = glm::vec2{r.x, r.z} - p;
                const float room_m = 0.5F * road.width_m + 2.5F;
                if (glm::dot(d, d) < room_m * room_m) return false;
            }
        return std::ranges::all_of(settled_.settlement.houses, [&](const scene::House& house) {
            const glm::vec2 d{house.foot_m.x - p.x, house.foot_m.z - p.y};
            return glm::dot(d, d) > 900 ||
                   scene::to_house_m(settled_.settlement.buildings[house.building], house, p) > 7;
        });
    }
    const scene::Land& land_;
    const Settled& settled_;
};

}  // namespace

Extent extent_of(const std::vector<glm::vec2>& outline_m) {
    Extent extent{outline_m.front(), outline_m.front()};
    for (const glm::vec2 p : outline_m) extent = {glm::min(extent.low_m, p), glm::max(extent.high_m, p)};
    return extent;
}

Inside::Inside(const std::vector<glm::vec2>& outline) {
    float area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::vec2 p = outline[i];
        const glm::vec2 q = outline[(i + 1) % outline.size()];
        area += p.x * q.y - p.y * q.x;
    }
    const float sign = area > 0 ? 1.0F : -1.0F;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::vec2 p = outline[i];
        const glm::vec2 d = outline[(i + 1) % outline.size()] - p;
        const float length = glm::length(d);
        if (length < 1.0e-4F) continue;
        const glm::vec2 in = sign / length * glm::vec2{-d.y, d.x};
        sides_.emplace_back(in, -glm::dot(in, p));
    }
}

std::vector<scene::FieldPlot> lay_fields(const scene::Land& land, const Settled& settled,
                                         const scene::LandParameters& parameters, base::Seed seed) {
    std::vector<scene::FieldPlot> fields;
    if (parameters.settle_fields <= 0.02F) return fields;
    const auto houses = static_cast<float>(settled.settlement.houses.size());
    const double reach_m =
        std::min(settled.reach_m + 30 + parameters.settle_fields * (60 + 5 * std::sqrt(houses) * 6), kMost_m);
    std::vector<glm::dvec2> region;
    for (int i = 0; i < 12; ++i) {
        const double turn = 0.5235987756 * i;
        region.emplace_back(settled.middle_m.x + reach_m * std::cos(turn),
                            settled.middle_m.y + reach_m * std::sin(turn));
    }
    mesh::TownRules rules;
    const double side_m = parameters.settle_field_m;
    rules.sites = std::clamp(static_cast<int>(3.0 * reach_m * reach_m / (5 * side_m * side_m)), 6, 160);
    rules.merged = 0.1;
    rules.street_m = 2.5;
    rules.lots = {side_m * side_m, 0.35 * side_m * side_m, 8, 0.25};
    const mesh::TownPlan plan = mesh::plan_town(region, rules, seed);
    const Tillage tillage(land, settled);
    for (std::size_t i = 0; i < plan.lots.size(); ++i) {
        base::RandomStream random{seed.child("field").child(i)};
        scene::FieldPlot field;
        for (const glm::dvec2 p : plan.lots[i].outline_m) field.outline_m.emplace_back(p);
        const float share = 0.25F + 0.75F * parameters.settle_fields;
        const float kind = random.unit_f();
        const float turn = random.between(0.92F, 1.06F);
        const float hedge = random.unit_f();
        if (random.unit_f() > share || !tillage.is_fit(field.outline_m)) continue;
        float longest = 0;
        for (std::size_t k = 0; k < field.outline_m.size(); ++k) {
            const glm::vec2 side = field.outline_m[(k + 1) % field.outline_m.size()] - field.outline_m[k];
            if (glm::length(side) <= longest) continue;
            longest = glm::length(side);
            field.along = side / longest;
        }
        const auto crop = std::min(static_cast<std::size_t>(kind * scene::kCrops), scene::kCrops - 1);
        field.crop = static_cast<scene::Crop>(crop);
        field.colour = turn * srgb_of(kLooks[crop].colour);
        field.rows = kLooks[crop].rows;
        field.has_hedge = hedge < parameters.settle_hedges;
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace quadrat::synthesis::houses
