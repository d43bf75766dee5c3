// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/additions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include "scene/colour.hpp"
#include "synthesis/houses/masses.hpp"
#include "synthesis/houses/roofs.hpp"
#include "synthesis/houses/walls.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr double kOverDormers_m = 2.5;  // a roof that rises less over its eaves has none
constexpr float kDeep_m = 3.0F;         // how deep a shed's walls reach: it stands on a slope

void add_everywhere(scene::Building& to, const Box& box, const Look& look, std::size_t levels = kLevels) {
    for (std::size_t level = 0; level < levels; ++level) add_box(to.levels[level], box, look);
}

// Of the roof over a place of the plan; 0 where there is none.
float roof_height_m(const scene::Masses& masses, glm::vec2 at) {
    const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
    float top_m = 0;
    for (std::size_t t = 0; t + 2 < masses.mesh.indices.size(); t += 3) {
        const glm::vec3& p = masses.mesh.positions_m[masses.mesh.indices[t]];
        const glm::vec3& q = masses.mesh.positions_m[masses.mesh.indices[t + 1]];
        const glm::vec3& r = masses.mesh.positions_m[masses.mesh.indices[t + 2]];
        const glm::vec2 a{p.x, p.z};
        const glm::vec2 to_q = glm::vec2{q.x, q.z} - a;
        const glm::vec2 to_r = glm::vec2{r.x, r.z} - a;
        const float area = cross(to_q, to_r);
        if (std::abs(area) < 1.0e-6F) continue;
        const float u = cross(at - a, to_r) / area;
        const float v = cross(to_q, at - a) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        top_m = std::max(top_m, p.y + u * (q.y - p.y) + v * (r.y - p.y));
    }
    return top_m;
}

struct Stack {
    glm::vec3 colour;
    scene::Cladding cladding;
    float wide_m, deep_m;
    int pots;
};

Stack stack_of(const Design& design, base::RandomStream& random) {
    const float drawn = random.unit_f();
    const glm::vec3 brick = scene::linear_from_srgb_hex(drawn < 0.3F ? 0x8A4B38 : 0x74503F);
    const bool is_stone = drawn > 0.55F;
    return {is_stone ? scene::shifted_colour(design.plinth.colour, 0.95F) : brick,
            is_stone ? scene::Cladding::Rubble : scene::Cladding::Slates, random.between(0.28F, 0.5F),
            random.between(0.24F, 0.32F), static_cast<int>(random.below(3))};
}

void add_stack(scene::Building& to, const Stack& stack, glm::vec3 foot, float top_m) {
    add_everywhere(to, {foot, {1, 0, 0}, {stack.wide_m, top_m - foot.y, stack.deep_m}},
                   {stack.colour, stack.cladding, 0});
    const glm::vec3 crown{foot.x, top_m, foot.z};
    add_everywhere(to, {crown, {1, 0, 0}, {stack.wide_m + 0.07F, 0.12F, stack.deep_m + 0.07F}},
                   {stack.colour * 0.7F, scene::Cladding::Plain, 0}, 2);
    for (int pot = 0; pot < stack.pots; ++pot) {
        const float aside = stack.pots == 1 ? 0.0F : stack.wide_m * (static_cast<float>(pot) - 0.5F);
        add_everywhere(to, {crown + glm::vec3{aside, 0.12F, 0}, {1, 0, 0}, {0.12F, 0.28F, 0.12F}},
                       {{0.16F, 0.07F, 0.04F}, scene::Cladding::Plain, 0}, 1);
    }
    to.chimneys_m.push_back(crown + glm::vec3{0, stack.pots > 0 ? 0.4F : 0.15F, 0});
}

// A gable over a window that stands in a roof which slopes to the front.
struct Dormer {
    float x, front_z;  // of its middle and its face
    float foot_m, half_m = 0.62F, high_m = 1.15F, gable_m = 0.5F;
};

void add_dormer(scene::Building& to, const Design& design, const Dormer& dormer, float lamp) {
    const auto steep = static_cast<float>(std::tan(glm::radians(design.pitch_deg)));
    const float top = dormer.foot_m + dormer.high_m;
    const float ridge = top + dormer.gable_m;
    const auto at = [&](float x, float y, float back) { return glm::vec3{dormer.x + x, y, dormer.front_z - back}; };
    const float w = dormer.half_m;
    const Look wall{scene::mix_colours(design.wood, glm::vec3{0.6F, 0.57F, 0.5F}, 0.6F), scene::Cladding::Planks, 0};
    const Look roof{design.roof.colour, design.roof.cladding, 0};
    const Look glass{scene::linear_from_srgb_hex(0x3A4754), scene::Cladding::Plain, lamp};
    const Look bars{scene::linear_from_srgb_hex(0xEFEBE0), scene::Cladding::Plain, 0};
    const float out = 0.18F;
    // The foot, top and ridge meet the roof so far behind the face.
    const float cheek = dormer.high_m / steep;
    const float behind = (dormer.high_m + dormer.gable_m) / steep + 0.1F;
    for (std::size_t level = 0; level < kLevels; ++level) {
        scene::Masses& m = to.levels[level];
        add_face(m,
                 std::array{at(-w, dormer.foot_m - 0.3F, 0), at(w, dormer.foot_m - 0.3F, 0), at(w, top, 0),
                            at(0, ridge, 0), at(-w, top, 0)},
                 wall);
        if (level < 2) {
            add_face(m, std::array{at(w, dormer.foot_m, 0), at(w, top, cheek), at(w, top, 0)}, wall);
            add_face(m, std::array{at(-w, dormer.foot_m, 0), at(-w, top, 0), at(-w, top, cheek)}, wall);
        }
        const float eave = top - 0.22F * dormer.gable_m / w;
        const float far = 0.22F + w;
        add_face(m,
                 std::array{at(far, eave, -out), at(far, eave, behind), at(0, ridge + 0.02F, behind),
                            at(0, ridge + 0.02F, -out)},
                 roof);
        add_face(m,
                 std::array{at(0, ridge + 0.02F, -out), at(0, ridge + 0.02F, behind), at(-far, eave, behind),
                            at(-far, eave, -out)},
                 roof);
        const float a = 0.7F * w;
        const float low = dormer.foot_m + 0.2F;
        const float high = top - 0.08F;
        add_face(m, std::array{at(-a, low, -0.02F), at(a, low, -0.02F), at(a, high, -0.02F), at(-a, high, -0.02F)},
                 glass);
        if (level > 0) continue;
        for (const glm::vec4 bar :
             {glm::vec4{-a - 0.06F, low, -a + 0.03F, high}, glm::vec4{a - 0.03F, low, a + 0.06F, high},
              glm::vec4{-0.03F, low, 0.03F, high}, glm::vec4{-a, high - 0.03F, a, high + 0.05F},
              glm::vec4{-a, low - 0.06F, a, low + 0.03F}})
            add_face(m,
                     std::array{at(bar.x, bar.y, -0.04F), at(bar.z, bar.y, -0.04F), at(bar.z, bar.w, -0.04F),
                                at(bar.x, bar.w, -0.04F)},
                     bars);
    }
}

}  // namespace

void add_chimneys(scene::Building& to, const Design& design, double ridge_m, base::Seed seed) {
    base::RandomStream random{seed.child("chimneys")};
    const auto ridge = static_cast<float>(ridge_m);
    const auto eaves = static_cast<float>(design.plinth_m + design.wall_m);
    const glm::vec2 half = half_of(design);
    const Stack stack = stack_of(design, random);
    const std::size_t already = to.chimneys_m.size();
    for (int i = 0; i < design.chimneys; ++i) {
        glm::vec2 best{0};
        float best_m = -1;
        constexpr int kTries = 64;
        for (int k = 0; k < kTries; ++k) {
            const glm::vec2 at = half * glm::vec2{random.between(-0.85F, 0.85F), random.between(-0.8F, 0.8F)};
            const float here_m = roof_height_m(to.levels.back(), at);
            const bool is_apart = std::none_of(to.chimneys_m.begin() + static_cast<std::ptrdiff_t>(already),
                                               to.chimneys_m.end(), [&](const glm::vec3& other) {
                                                   return glm::distance(glm::vec2{other.x, other.z}, at) < 2.2F;
                                               });
            if (!is_apart || here_m <= best_m) continue;
            best_m = here_m;
            best = at;
            if (here_m > eaves + 0.965F * (ridge - eaves)) break;
        }
        if (best_m < eaves) return;
        const float top_m = std::max(best_m + 0.9F, ridge + random.between(0.3F, 0.95F));
        add_stack(to, stack, {best.x, best_m - 0.6F, best.y}, top_m);
    }
}

void add_dormers(scene::Building& to, const Design& design, base::Seed seed) {
    const glm::dvec2 a = design.footprint.plan[0];
    const glm::dvec2 b = design.footprint.plan[1];
    const double width_m = b.x - a.x;
    const double depth_m = glm::distance(design.footprint.plan.back(), a);
    if (design.dormers <= 0 || is_gable(design, 0) || rise_m(design, depth_m) < kOverDormers_m) return;
    const auto steep = static_cast<float>(std::tan(glm::radians(design.pitch_deg)));
    const int most = static_cast<int>((width_m - 2.2) / 2.0);
    const int count = std::min(design.dormers, most);
    base::RandomStream random{seed.child("dormers")};
    for (int i = 0; i < count; ++i) {
        const auto share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        Dormer dormer{};
        const float inset_m = std::min(0.75F, 0.5F / steep);
        dormer.x = static_cast<float>(a.x) + 1.1F + share * (static_cast<float>(width_m) - 2.2F);
        dormer.front_z = static_cast<float>(-a.y) - inset_m;
        dormer.foot_m = static_cast<float>(design.plinth_m + design.wall_m + over_walls_m(design)) + inset_m * steep;
        add_dormer(to, design, dormer, 0.02F + 0.98F * random.unit_f());
    }
}

void add_lean_tos(scene::Building& to, const Design& design) {
    const std::vector<glm::dvec2>& plan = design.footprint.plan;
    const auto plinth = static_cast<float>(design.plinth_m);
    for (const LeanTo& shed : design.lean_tos) {
        const glm::dvec2 corner = plan[shed.side];
        const glm::dvec2 d = glm::normalize(plan[(shed.side + 1) % plan.size()] - corner);
        const auto at = [&](double along, double out, double high) {
            const glm::dvec2 p = corner + along * d + out * glm::dvec2{d.y, -d.x};
            return glm::vec3{p.x, plinth + high, -p.y};
        };
        const double w = shed.width_m;
        const double s = shed.from_m;
        const double deep = shed.depth_m;
        const double ground = -kDeep_m;
        const double fall = (shed.high_m - shed.low_m) / deep;
        const Look wall{scene::mix_colours(design.wood, glm::vec3{0.25F, 0.2F, 0.15F}, 0.5F), scene::Cladding::Planks,
                        0};
        const Look roof{design.roof.colour * 0.9F, design.roof.cladding, 0};
        const Look dark{design.wood * 0.4F, scene::Cladding::Plain, 0};
        for (std::size_t level = 0; level < kLevels; ++level) {
            scene::Masses& m = to.levels[level];
            add_face(m,
                     std::array{at(s, deep, ground), at(s + w, deep, ground), at(s + w, deep, shed.low_m),
                                at(s, deep, shed.low_m)},
                     wall);
            add_face(m,
                     std::array{at(s, 0, ground), at(s, deep, ground), at(s, deep, shed.low_m), at(s, 0, shed.high_m)},
                     wall);
            add_face(m,
                     std::array{at(s + w, deep, ground), at(s + w, 0, ground), at(s + w, 0, shed.high_m),
                                at(s + w, deep, shed.low_m)},
                     wall);
            const double over = 0.25;
            const double eave = shed.low_m - fall * over + 0.08;
            const double top = shed.high_m + 0.08;
            add_face(m,
                     std::array{at(s - over, deep + over, eave), at(s + w + over, deep + over, eave),
                                at(s + w + over, 0, top), at(s - over, 0, top)},
                     roof);
            if (level == 2) continue;
            add_face(m,
                     std::array{at(s - over, deep + over, eave - 0.14), at(s + w + over, deep + over, eave - 0.14),
                                at(s + w + over, deep + over, eave), at(s - over, deep + over, eave)},
                     dark);
            const double door = std::min(s + w - 1.1, s + 0.4);
            add_face(
                m,
                std::array{at(door, deep + 0.02, -plinth), at(door + 0.85, deep + 0.02, -plinth),
                           at(door + 0.85, deep + 0.02, shed.low_m - 0.25), at(door, deep + 0.02, shed.low_m - 0.25)},
                dark);
        }
    }
}

void add_tower(scene::Building& to, const Design& design, base::Seed seed) {
    double front = -1e9;
    for (const glm::dvec2 p : design.footprint.plan) front = std::max(front, -p.y);
    Design tower = design;
    tower.footprint = rectangle(2 * kTowerHalf_m, 2 * kTowerHalf_m);
    for (glm::dvec2& p : tower.footprint.plan) p.y -= front;
    tower.form = RoofForm::Hipped;
    tower.wall_m = design.tower_m;
    tower.pitch_deg = 68;
    tower.eave_m = 0.25;
    tower.chimneys = 0;
    tower.dormers = 0;
    tower.tower_m = 0;
    const scene::Building whole = build(tower, seed.child("tower"));
    for (std::size_t level = 0; level < kLevels; ++level) {
        scene::Masses& masses = to.levels[level];
        const scene::Masses& add = whole.levels[level];
        const auto first = static_cast<std::uint32_t>(masses.mesh.positions_m.size());
        const auto append = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
        append(masses.mesh.positions_m, add.mesh.positions_m);
        append(masses.mesh.normals, add.mesh.normals);
        append(masses.mesh.texcoords, add.mesh.texcoords);
        append(masses.colours, add.colours);
        append(masses.claddings, add.claddings);
        append(masses.lamps, add.lamps);
        for (const std::uint32_t index : add.mesh.indices) masses.mesh.indices.push_back(first + index);
    }
    to.height_m = std::max(to.height_m, whole.height_m);
}

}  // namespace quadrat::synthesis::houses
