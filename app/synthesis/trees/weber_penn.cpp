// SPDX-License-Identifier: Apache-2.0
// Weber & Penn 1995, sections 4.1 to 4.8. Ours places a node where a limb is borne, so that each begins on its bearer;
// pruning, lobes and leaves are done elsewhere, the same for every grower.
#include "synthesis/trees/weber_penn.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

constexpr float kGolden_deg = 137.50776F;

float shape_ratio(Outline shape, float ratio) {
    const float pi = 3.14159265F;
    switch (shape) {
        case Outline::Conical:
            return 0.2F + 0.8F * ratio;
        case Outline::Spherical:
            return 0.2F + 0.8F * std::sin(pi * ratio);
        case Outline::Hemispherical:
            return 0.2F + 0.8F * std::sin(0.5F * pi * ratio);
        case Outline::Cylindrical:
            return 1;
        case Outline::TaperedCylindrical:
            return 0.5F + 0.5F * ratio;
        case Outline::Flame:
            return ratio <= 0.7F ? ratio / 0.7F : (1 - ratio) / 0.3F;
        case Outline::InverseConical:
            return 1 - 0.8F * ratio;
        case Outline::TendFlame:
            return ratio <= 0.7F ? 0.5F + 0.5F * ratio / 0.7F : 0.5F + 0.5F * (1 - ratio) / 0.3F;
    }
    return 1;
}

struct Frame {
    glm::vec3 heading{0, 1, 0};
    glm::vec3 side{1, 0, 0};  // the axis that positive curves bend about
    void turn(const glm::vec3& axis, float deg) {
        const glm::quat q = glm::angleAxis(glm::radians(deg), axis);
        heading = glm::normalize(q * heading);
        side = q * side;
        side = glm::normalize(side - glm::dot(side, heading) * heading);
    }
};

struct Stem {
    int level = 0;
    Frame frame;
    glm::vec3 at_m{0};
    float length = 1;
    float radius = 0.02F;
    int parent = -1;
    int parent_node = 0;
    int first_segment = 0;  // of a clone: how far its stem had grown
    float rotation_deg = 0;
    float place = 1;  // on its bearer, 1 the lowest to 0 the top
};

class Grower {
  public:
    Grower(const WeberPenn& p, base::Seed seed, std::size_t most) : p_(p), seed_(seed), most_(most) {}

    TreeSkeleton grow() {
        Stem trunk;
        trunk.length = 1;
        trunk.radius = p_.ratio;
        base::RandomStream random{seed_};
        trunk.frame.turn({0, 1, 0}, random.between(0, 360));
        pending_.push_back(trunk);
        // By order of birth, so that a budget cuts the latest twigs and not one side of the crown.
        for (std::size_t i = 0; i < pending_.size() && skeleton_.limbs.size() < most_; ++i) {
            const Stem stem = pending_[i];
            lengthen(stem);
        }
        measure(skeleton_);
        return std::move(skeleton_);
    }

  private:
    const WeberPenn::Level& level_of(const Stem& stem) const { return p_.level[std::min(stem.level, 2)]; }

    float radius_at(const Stem& stem, float along) const {
        const float taper = level_of(stem).taper;
        return stem.radius * std::max(1.0F - std::min(taper, 1.0F) * along, 0.06F);
    }

    void lengthen(const Stem& stem) {
        const WeberPenn::Level& l = level_of(stem);
        const auto index = static_cast<int>(skeleton_.limbs.size());
        base::RandomStream random{seed_.child("stem").child(static_cast<std::uint64_t>(index))};
        Limb limb;
        limb.order = stem.level;
        limb.parent = stem.parent;
        limb.parent_node = stem.parent_node;
        const int segments = std::max(l.curve_res, 1);
        const float step = stem.length / static_cast<float>(segments);
        const float begun = static_cast<float>(stem.first_segment) / static_cast<float>(segments);
        limb.nodes.push_back({stem.at_m, radius_at(stem, begun), 0, 0});
        skeleton_.limbs.push_back({});
        Frame frame = stem.frame;
        glm::vec3 at = stem.at_m;
        Bearing bearing = bearing_of(stem, random);
        float split_error = random.between(-0.5F, 0.5F);
        for (int s = stem.first_segment; s < segments; ++s) {
            const glm::vec3 from = at;
            at += step * frame.heading;
            bear(stem, frame, from, at, s, segments, limb, index, bearing, random);
            const float along = static_cast<float>(s + 1) / static_cast<float>(segments);
            limb.nodes.push_back({at, radius_at(stem, along), 0, 0});
            if (s + 1 == segments) break;
            split(stem, frame, at, s, limb, index, bearing, split_error, random);
            curve(stem, frame, s, segments, random);
        }
        skeleton_.limbs[index] = std::move(limb);
    }

    // How a stem bears: children or leaves, so many a segment, turning as it goes.
    struct Bearing {
        bool is_leafy = false;
        float each = 0;  // a segment
        float error = 0;
        float rotation_deg = 0;
        float sign = 1;
    };

    Bearing bearing_of(const Stem& stem, base::RandomStream& random) const {
        Bearing b;
        b.is_leafy = stem.level + 1 >= p_.levels;
        b.rotation_deg = stem.first_segment > 0 ? stem.rotation_deg : random.between(0, 360);
        float count = p_.leaves;
        if (!b.is_leafy) {
            const WeberPenn::Level& next = p_.level[std::min(stem.level + 1, 2)];
            count = next.branches;
            if (stem.level > 0) {
                const float usual = std::max(level_of(stem).length, 0.01F);
                count *= 0.2F + 0.8F * std::min(stem.length / usual, 1.0F);
            }
            count /= std::max(1.0F - (stem.level == 0 ? p_.base_size : 0), 0.1F);
        } else if (p_.levels > 1) {
            count *= std::sqrt(std::clamp(4 * stem.length, 0.15F, 1.0F));
        }
        b.each = count / static_cast<float>(std::max(level_of(stem).curve_res, 1));
        return b;
    }

    void bear(const Stem& stem, const Frame& frame, const glm::vec3& from, const glm::vec3& to, int segment,
              int segments, Limb& limb, int index, Bearing& b, base::RandomStream& random) {
        const float base = stem.level == 0 ? p_.base_size : (b.is_leafy ? 0.1F : 0.06F);
        const float wanted = b.each + b.error;
        const int count = std::max(static_cast<int>(std::floor(wanted + 0.5F)), 0);
        b.error = std::clamp(wanted - static_cast<float>(count), -1.0F, 1.0F);
        for (int k = 0; k < count; ++k) {
            const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(count);
            const float along = (static_cast<float>(segment) + t) / static_cast<float>(segments);
            if (along < base) continue;
            const glm::vec3 at = from + t * (to - from);
            const bool is_crown_shaft = b.is_leafy && p_.levels == 1;
            const WeberPenn::Level& next = p_.level[std::min(stem.level + 1, 2)];
            b.rotation_deg += is_crown_shaft ? kGolden_deg
                              : b.is_leafy   ? kGolden_deg
                              : next.rotate < 0
                                  ? 180.0F + b.sign * (-next.rotate - 90) + next.rotate_v * random.between(-1, 1)
                                  : next.rotate + next.rotate_v * random.between(-1, 1);
            b.sign = -b.sign;
            Frame child = frame;
            child.turn(frame.heading, b.rotation_deg);
            if (b.is_leafy) {
                add_site(child, at, limb, index);
                continue;
            }
            limb.nodes.push_back({at, radius_at(stem, along), 0, 0});
            add_child(stem, child, at, along, limb, index, random);
        }
    }

    void add_site(const Frame& frame, const glm::vec3& at, const Limb& limb, int index) {
        Site site;
        site.at_m = at;
        site.along = frame.heading;
        site.out = frame.side;
        site.limb = index;
        site.node = static_cast<int>(limb.nodes.size()) - 1;
        skeleton_.sites.push_back(site);
    }

    void add_child(const Stem& stem, Frame frame, const glm::vec3& at, float along, const Limb& limb, int index,
                   base::RandomStream& random) {
        const WeberPenn::Level& next = p_.level[std::min(stem.level + 1, 2)];
        Stem child;
        child.level = stem.level + 1;
        child.at_m = at;
        child.parent = index;
        child.parent_node = static_cast<int>(limb.nodes.size()) - 1;
        const float base = stem.level == 0 ? p_.base_size : 0;
        child.place = std::clamp((1 - along) / std::max(1 - base, 0.01F), 0.0F, 1.0F);
        const float down =
            next.down_angle_v >= 0
                ? next.down_angle + next.down_angle_v * random.between(-1, 1)
                : next.down_angle + next.down_angle_v * (1 - 2 * shape_ratio(Outline::Conical, child.place));
        frame.turn(frame.side, down);
        child.frame = frame;
        const float own = std::max(next.length + next.length_v * random.between(-1, 1), 0.02F);
        child.length = stem.level == 0 ? stem.length * own * shape_ratio(p_.shape, child.place)
                                       : own * (stem.length - 0.6F * along * stem.length);
        child.radius = std::min(p_.ratio * std::pow(std::max(child.length, 1.0e-3F), p_.ratio_power),
                                0.85F * radius_at(stem, along));
        pending_.push_back(child);
    }

    void split(const Stem& stem, Frame& frame, const glm::vec3& at, int segment, const Limb& limb, int index,
               Bearing& b, float& error, base::RandomStream& random) {
        const WeberPenn::Level& l = level_of(stem);
        const bool is_base = stem.level == 0 && segment == 0 && stem.first_segment == 0;
        float wanted = (is_base ? static_cast<float>(p_.base_splits) : l.seg_splits) + error;
        const int clones = std::max(static_cast<int>(std::floor(wanted + 0.5F)), 0);
        error = std::clamp(wanted - static_cast<float>(clones), -1.0F, 1.0F);
        if (clones == 0) return;
        const float angle = l.split_angle + l.split_angle_v * random.between(-1, 1);
        const Frame before = frame;
        for (int k = 0; k < clones; ++k) {
            Stem clone = stem;
            clone.at_m = at;
            clone.parent = index;
            clone.parent_node = static_cast<int>(limb.nodes.size()) - 1;
            clone.first_segment = segment + 1;
            clone.rotation_deg = b.rotation_deg + 90;
            clone.frame = before;
            clone.frame.turn(before.heading, 360.0F * static_cast<float>(k + 1) / static_cast<float>(clones + 1) +
                                                 random.between(-25, 25));
            clone.frame.turn(clone.frame.side, angle);
            clone.radius *= 0.9F;
            pending_.push_back(clone);
        }
        frame.turn(frame.side, angle);
        b.each *= 1.0F / (1.0F + 0.5F * static_cast<float>(clones));
    }

    void curve(const Stem& stem, Frame& frame, int segment, int segments, base::RandomStream& random) const {
        const WeberPenn::Level& l = level_of(stem);
        const auto n = static_cast<float>(segments);
        float deg = l.curve / n;
        if (l.curve_back != 0) deg = (2 * segment < segments ? l.curve : l.curve_back) / (0.5F * n);
        frame.turn(frame.side, deg + l.curve_v / n * random.between(-1, 1));
        // A second, sideways share keeps limbs from lying in one plane.
        frame.turn(glm::cross(frame.side, frame.heading), 0.6F * l.curve_v / n * random.between(-1, 1));
        // A stem rights itself.
        const float up = stem.level == 0 ? 2.2F : p_.attraction_up;
        if (up == 0) return;
        const glm::vec3 toward{0, up > 0 ? 1.0F : -1.0F, 0};
        const glm::vec3 axis = glm::cross(frame.heading, toward);
        const float sine = glm::length(axis);
        if (sine > 1.0e-3F) frame.turn(axis / sine, glm::degrees(std::abs(up) * sine / n));
    }

    const WeberPenn& p_;
    base::Seed seed_;
    std::size_t most_;
    TreeSkeleton skeleton_;
    std::vector<Stem> pending_;
};

}  // namespace

TreeSkeleton grow_weber_penn(const WeberPenn& parameters, base::Seed seed, std::size_t most_limbs) {
    return Grower(parameters, seed, most_limbs).grow();
}

}  // namespace quadrat::synthesis::trees
