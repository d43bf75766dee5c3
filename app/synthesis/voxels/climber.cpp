// SPDX-License-Identifier: Apache-2.0
#include "synthesis/voxels/climber.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"
#include "synthesis/voxels/shadow_grid.hpp"

namespace quadrat::synthesis::voxels {
namespace {

constexpr float kOff_m = 0.03F;  // a shoot lies on its hold
constexpr int kTries = 9;        // of a step
constexpr std::size_t kLeavesAtOnce = 32;

struct Tip {
    int node;
    glm::vec3 way;
};

class Growth {
  public:
    Growth(const Surroundings& around, const Climber& climber, base::Seed seed)
        : around_(around),
          climber_(climber),
          random_(seed),
          light_({}, glm::vec3{0}, around.cells()),
          taken_(static_cast<std::size_t>(around.cells().x) * static_cast<std::size_t>(around.cells().y) *
                 static_cast<std::size_t>(around.cells().z)) {
        std::vector<ShadowGrid::Change> solid;
        const glm::ivec3 cells = around.cells();
        for (int y = 0; y < cells.y; ++y)
            for (int z = 0; z < cells.z; ++z)
                for (int x = 0; x < cells.x; ++x)
                    if (around.at({x, y, z}) != Surroundings::Kind::Air)
                        solid.push_back({glm::vec3{x, y, z} + 0.5F, true});
        light_.apply(solid);
    }

    void root(const glm::vec3& at_m) {
        Surroundings::Hold hold;
        if (!around_.find_hold(at_m, hold) || shoots_.size() >= climber_.most) return;
        base_m_ = shoots_.empty() ? hold.at_m.y : std::min(base_m_, hold.at_m.y);
        add({hold.at_m + kOff_m * hold.out, hold.out, {0, 1, 0}, -1});
    }

    std::vector<Tendril> grow() {
        while (!tips_.empty() && shoots_.size() < climber_.most) {
            const Tip tip = tips_.front();
            tips_.pop_front();
            if (!step(tip)) continue;
            if (random_.unit_f() < climber_.branching) tips_.push_back({tip.node, aside(shoots_[at(tip.node)])});
        }
        return std::move(shoots_);
    }

  private:
    static std::size_t at(int node) { return static_cast<std::size_t>(node); }

    void add(const Tendril& tendril) {
        tips_.push_back({static_cast<int>(shoots_.size()), tendril.way});
        taken(tendril.at_m) = true;
        // Together, as each change raises the grid's whole roof.
        leaves_.push_back({(tendril.at_m - around_.low_m()) / around_.cell_m(), true});
        if (leaves_.size() >= kLeavesAtOnce) {
            light_.apply(leaves_);
            leaves_.clear();
        }
        shoots_.push_back(tendril);
    }

    std::vector<bool>::reference taken(const glm::vec3& at_m) {
        const glm::ivec3 c = glm::clamp(around_.cell_of(at_m), glm::ivec3{0}, around_.cells() - 1);
        return taken_[(at(c.y) * at(around_.cells().z) + at(c.z)) * at(around_.cells().x) + at(c.x)];
    }

    glm::vec3 chance_way() { return {random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)}; }

    static glm::vec3 along(const glm::vec3& way, const glm::vec3& out) {
        const glm::vec3 flat = way - glm::dot(way, out) * out;
        const float length = glm::length(flat);
        return length > 1.0e-4F ? flat / length : glm::vec3{0, 1, 0};
    }

    glm::vec3 aside(const Tendril& from) {
        const glm::vec3 side = glm::cross(from.out, from.way);
        return along(from.way + (random_.unit_f() < 0.5F ? -1.6F : 1.6F) * side, from.out);
    }

    bool step(const Tip& tip) {
        const Tendril from = shoots_[at(tip.node)];
        Tendril best;
        float most = -1;
        for (int i = 0; i < kTries; ++i) {
            const glm::vec3 wish = 0.8F * tip.way + climber_.upward * glm::vec3{0, 1, 0} + 1.1F * chance_way();
            const glm::vec3 way = along(wish, from.out);
            const float chance = random_.unit_f();
            const glm::vec3 to = from.at_m + around_.cell_m() * way;
            Surroundings::Hold hold;
            // Around an edge the hold lies behind.
            if (!around_.find_hold(to, hold) && !around_.find_hold(to - around_.cell_m() * from.out, hold)) continue;
            if (hold.at_m.y > base_m_ + climber_.high_m || hold.at_m.y < base_m_ - around_.cell_m()) continue;
            const glm::vec3 place = hold.at_m + kOff_m * hold.out;
            if (taken(place)) continue;
            const float light = light_.light_at((place - around_.low_m()) / around_.cell_m());
            const float worth = 0.5F * chance + 0.5F * light + climber_.upward * way.y + 1;
            if (worth <= most) continue;
            most = worth;
            best = {place, hold.out, way, tip.node};
        }
        if (most < 0) return false;
        add(best);
        return true;
    }

    const Surroundings& around_;
    const Climber& climber_;
    base::RandomStream random_;
    ShadowGrid light_;
    std::vector<ShadowGrid::Change> leaves_;  // that it does not know yet
    std::vector<bool> taken_;
    std::vector<Tendril> shoots_;
    std::deque<Tip> tips_;
    float base_m_ = 0;
};

}  // namespace

Surroundings::Surroundings(const glm::vec3& low_m, const glm::vec3& high_m, float cell_m)
    : low_m_(low_m),
      cell_m_(cell_m),
      cells_(glm::max(glm::ivec3{glm::ceil((high_m - low_m) / cell_m)}, glm::ivec3{1})),
      kinds_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
             static_cast<std::size_t>(cells_.z)),
      holds_(kinds_.size()) {}

glm::ivec3 Surroundings::cell_of(const glm::vec3& at_m) const {
    return glm::ivec3{glm::floor((at_m - low_m_) / cell_m_)};
}

bool Surroundings::is_inside(const glm::ivec3& c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < cells_.x && c.y < cells_.y && c.z < cells_.z;
}

Surroundings::Kind Surroundings::at(const glm::ivec3& cell) const {
    return is_inside(cell) ? kinds_[flat(cell)] : Kind::Air;
}

void Surroundings::add_face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Kind kind) {
    const glm::vec3 high_m = low_m_ + cell_m_ * glm::vec3{cells_};
    for (int k = 0; k < 3; ++k)
        if (std::max({a[k], b[k], c[k]}) < low_m_[k] || std::min({a[k], b[k], c[k]}) > high_m[k]) return;
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float area2 = glm::length(normal);
    if (area2 < 1.0e-6F) return;
    const glm::vec3 out = normal / area2;
    // Samples no more than half a cell apart, along the two sides that are not the longest: many faces are narrow.
    std::array<glm::vec3, 3> corner{a, b, c};
    const float ab = glm::distance(a, b), bc = glm::distance(b, c), ca = glm::distance(c, a);
    if (ab > bc && ab > ca) corner = {c, a, b};
    if (ca > ab && ca > bc) corner = {b, c, a};
    const glm::vec3 one = corner[1] - corner[0], other = corner[2] - corner[0];
    const auto steps = [this](const glm::vec3& side) {
        return std::clamp(static_cast<int>(std::ceil(2 * glm::length(side) / cell_m_)), 1, 400);
    };
    const int along = steps(one), across = steps(other);
    for (int i = 0; i <= along; ++i)
        for (int j = 0; i * across + j * along <= along * across; ++j) {
            const float u = static_cast<float>(i) / static_cast<float>(along);
            const float v = static_cast<float>(j) / static_cast<float>(across);
            const glm::vec3 at_m = corner[0] + u * one + v * other;
            const glm::ivec3 cell = cell_of(at_m);
            if (!is_inside(cell)) continue;
            Kind& there = kinds_[flat(cell)];
            if (there == Kind::Bare) continue;
            there = kind;
            holds_[flat(cell)] = {at_m, out};
        }
}

// In its own cell, or where rounding has put it into the next.
bool Surroundings::holds_at(const glm::vec3& at_m, const glm::vec3& out) const {
    constexpr float kRounded = 0.2F;
    for (const float by : {0.0F, -kRounded, kRounded})
        if (at(cell_of(at_m + by * cell_m_ * out)) == Kind::Hold) return true;
    return false;
}

bool Surroundings::find_hold(const glm::vec3& at_m, Hold& hold) const {
    const glm::ivec3 middle = cell_of(at_m);
    float nearest = 1.0e9F;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::ivec3 cell = middle + glm::ivec3{dx, dy, dz};
                const Kind kind = at(cell);
                if (kind == Kind::Bare) return false;
                if (kind == Kind::Air) continue;
                const Hold& one = holds_[flat(cell)];
                const glm::vec3 off = at_m - one.at_m;
                const float away = glm::dot(off, off);
                if (away >= nearest) continue;
                // On the face that goes through there, as far as it reaches.
                const glm::vec3 on_face = at_m - glm::dot(off, one.out) * one.out;
                if (!holds_at(on_face, one.out)) continue;
                nearest = away;
                hold = {on_face, one.out};
            }
    return nearest < 4 * cell_m_ * cell_m_;
}

std::vector<Tendril> climb(const Surroundings& around, std::span<const glm::vec3> roots_m, const Climber& climber,
                           base::Seed seed) {
    Growth growth(around, climber, seed);
    for (const glm::vec3& root : roots_m) growth.root(root);
    return growth.grow();
}

glm::vec3 climber_colour(float redness, base::Seed seed) {
    base::RandomStream random{seed};
    const bool is_red = random.unit_f() < redness;
    const glm::vec3 colour = scene::linear_from_srgb_hex(is_red ? 0x8E3E2C : 0x55733A);
    return scene::shifted_colour(colour, random.between(0.85F, 1.12F));
}

}  // namespace quadrat::synthesis::voxels
