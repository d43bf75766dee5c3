// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/topiary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "scene/colour.hpp"
#include "synthesis/trees/crown_fringe.hpp"
#include "synthesis/trees/crown_mass.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/leaf_picture.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/phyllotaxis.hpp"
#include "synthesis/trees/wood_levels.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kInternode = 0.045F;  // to the height
constexpr float kStem = 0.045F;       // radius of a bare stem's room
constexpr float kTrunk = 0.018F;      // its own
constexpr std::size_t kMostLimbs = 320;
constexpr int kMostOrder = 3;  // of shoots whose buds wake without a cut,
constexpr float kWakesAlone = 0.75F;
constexpr std::size_t kDominates_nodes = 2;
constexpr std::size_t kBlades = 1100;
constexpr int kWakes = 2;            // buds, a cut
constexpr int kWithin_nodes = 5;     // so far below it
constexpr float kLeans_rad = 1.05F;  // of a side shoot, from the one that bears it

bool is_in_ball(const glm::vec3& at, float middle, float radius) {
    return glm::length(at - glm::vec3{0, middle, 0}) < radius;
}

// Of the shape, but for a bare stem.
bool is_leafy(TopiaryShape shape, const glm::vec3& at) {
    const float aside = std::hypot(at.x, at.z);
    switch (shape) {
        case TopiaryShape::None:
            return false;
        case TopiaryShape::Cone:
            return at.y > 0.03F && at.y < 1 && aside < 0.31F * (1 - at.y) + 0.005F;
        case TopiaryShape::BallOnStem:
            return is_in_ball(at, 0.72F, 0.28F);
        case TopiaryShape::Tiers:
            return is_in_ball(at, 0.24F, 0.23F) || is_in_ball(at, 0.60F, 0.17F) || is_in_ball(at, 0.87F, 0.12F);
        case TopiaryShape::Obelisk: {
            const float half = at.y < 0.78F ? 0.22F - 0.08F * at.y : 0.158F * (1 - at.y) / 0.22F;
            return at.y > 0.02F && at.y < 1 && std::max(std::abs(at.x), std::abs(at.z)) < half;
        }
    }
    return false;
}

struct Bud {
    std::size_t node;
    glm::vec3 way;
    bool is_dormant = true;
};

struct Shoot {
    Limb limb;
    glm::vec3 way;
    std::vector<Bud> buds;
    bool is_cut = false;
};

// In units of the height.
class Clipped {
  public:
    Clipped(TopiaryShape shape, base::Seed seed) : shape_(shape), random_(seed) {
        Shoot stem;
        stem.limb.nodes = {{{0, -0.02F, 0}, kTrunk, 0, 0}, {{0, kInternode, 0}, kTrunk, 0, 0}};
        stem.way = {0, 1, 0};
        shoots_.push_back(std::move(stem));
    }

    TreeSkeleton grow(float height_m) {
        constexpr int kSteps = 60;
        for (int i = 0; i < kSteps; ++i)
            for (std::size_t k = 0, now = shoots_.size(); k < now; ++k) step(k);
        TreeSkeleton skeleton;
        for (std::size_t k = 0; k < shoots_.size(); ++k) {
            Shoot& shoot = shoots_[k];
            const auto limb = static_cast<int>(skeleton.limbs.size());
            for (std::size_t n = 1; n < shoot.limb.nodes.size(); ++n) add_site(skeleton, shoot, limb, n);
            for (Limb::Node& node : shoot.limb.nodes) {
                node.at_m *= height_m;
                node.radius_m *= height_m;
            }
            skeleton.limbs.push_back(std::move(shoot.limb));
        }
        for (Site& site : skeleton.sites) site.at_m *= height_m;
        measure(skeleton);
        return skeleton;
    }

  private:
    void step(std::size_t k) {
        if (shoots_[k].is_cut) return;
        const glm::vec3 chance{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
        Shoot& shoot = shoots_[k];
        const glm::vec3 from = shoot.limb.nodes.back().at_m;
        // The stem is tied to a stake.
        shoot.way = k == 0 ? glm::normalize(glm::vec3{-2 * from.x, 1, -2 * from.z} + 0.08F * chance)
                           : glm::normalize(shoot.way + 0.12F * chance + glm::vec3{0, 0.03F, 0});
        const glm::vec3 to = from + kInternode * shoot.way;
        if (!is_within(shape_, to)) {
            shoot.is_cut = true;
            return wake(k);
        }
        const float radius = std::max(0.93F * shoot.limb.nodes.back().radius_m, 0.002F);
        shoot.limb.nodes.push_back({to, radius, 0, 0});
        const float turn = kGoldenAngle_rad * static_cast<float>(shoot.limb.nodes.size() + 3 * k);
        const glm::vec3 any = std::abs(shoot.way.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
        const glm::vec3 side = glm::normalize(glm::cross(shoot.way, any));
        const glm::vec3 other = glm::cross(shoot.way, side);
        const glm::vec3 out = std::cos(turn) * side + std::sin(turn) * other;
        shoot.buds.push_back(
            {shoot.limb.nodes.size() - 1, std::cos(kLeans_rad) * shoot.way + std::sin(kLeans_rad) * out});
        // A tip keeps only those asleep that are near to it.
        if (shoot.limb.order < kMostOrder && random_.unit_f() < kWakesAlone) wake_one(k, kDominates_nodes);
    }

    // The signal goes down from the cut, and over to what bears the shoot.
    void wake(std::size_t k) {
        int left = kWakes;
        for (int i = 0; i < kWithin_nodes && left > 0; ++i)
            if (wake_one(k, static_cast<std::size_t>(i))) --left;
        const int parent = shoots_[k].limb.parent;
        if (left > 0 && parent >= 0) wake_one(static_cast<std::size_t>(parent), 0);
    }

    // The nth bud from the tip that sleeps and has room.
    bool wake_one(std::size_t k, std::size_t from_tip) {
        if (shoots_.size() >= kMostLimbs || from_tip >= shoots_[k].buds.size()) return false;
        Bud& bud = shoots_[k].buds[shoots_[k].buds.size() - 1 - from_tip];
        const Limb::Node node = shoots_[k].limb.nodes[bud.node];
        const glm::vec3 tip = node.at_m + kInternode * bud.way;
        if (!bud.is_dormant || !is_within(shape_, tip)) return false;
        bud.is_dormant = false;
        Shoot side;
        side.limb.parent = static_cast<int>(k);
        side.limb.parent_node = static_cast<int>(bud.node);
        side.limb.order = shoots_[k].limb.order + 1;
        side.limb.nodes = {{node.at_m, 0.6F * node.radius_m, 0, 0}, {tip, 0.55F * node.radius_m, 0, 0}};
        side.way = bud.way;
        shoots_.push_back(std::move(side));
        return true;
    }

    void add_site(TreeSkeleton& skeleton, const Shoot& shoot, int limb, std::size_t n) const {
        const glm::vec3 at = shoot.limb.nodes[n].at_m;
        const glm::vec3 along = glm::normalize(at - shoot.limb.nodes[n - 1].at_m);
        if (!is_leafy(shape_, at)) return;
        Site site;
        site.at_m = at;
        site.along = along;
        site.out = glm::normalize(glm::cross(along, glm::vec3{0.3F, 0.2F, 0.9F}));
        site.limb = limb;
        site.node = static_cast<int>(n) - 1;
        // What is clipped is densest at its surface.
        const bool is_outer = !is_within(shape_, at + glm::vec3{1.12F * at.x, 0.06F, 1.12F * at.z} * 0.25F);
        site.weight = is_outer ? 4.0F : 1.0F;
        skeleton.sites.push_back(site);
    }

    TopiaryShape shape_;
    base::RandomStream random_;
    std::vector<Shoot> shoots_;
};

}  // namespace

bool is_within(TopiaryShape shape, const glm::vec3& at) {
    const bool has_stem = shape == TopiaryShape::BallOnStem || shape == TopiaryShape::Tiers;
    const bool is_in_stem = at.y > -0.05F && at.y < 0.7F && std::hypot(at.x, at.z) < kStem;
    return is_leafy(shape, at) || (has_stem && is_in_stem);
}

TreeSkeleton clipped_skeleton(const TopiaryOptions& options, base::Seed seed) {
    return Clipped(options.shape, seed).grow(options.height_m);
}

scene::Species topiary(const TopiaryOptions& o, base::Seed seed) {
    const TreeSkeleton skeleton = clipped_skeleton(o, seed.child("shoots"));
    scene::Species species;
    species.name = "topiary";
    species.storey = scene::Storey::Shrub;
    species.density = species.share = 0;
    TubeDetail near;
    near.trunk_sides = 4;
    near.has_foot = false;
    TubeDetail far = near;
    far.most_nodes = 12;
    far.flattest = 2;
    species.wood = {sweep_tubes(skeleton, near), sweep_tubes(skeleton, far)};
    species.wood.back().left_out_m = thickest_left_out_m(skeleton, far.most_nodes);
    set_coarser(species.wood, kTrunk * o.height_m);
    FoliageOptions foliage;
    foliage.kind = LeafKind::Ovate;
    foliage.blades = kBlades;
    foliage.length_m = 0.078F * o.height_m;
    foliage.width = 1.3F;
    foliage.scatter_m = 0.02F * o.height_m;
    foliage.clumping = 0;
    foliage.droop = 0;
    foliage.outward = 0.2F;  // cut leaves do not stand off
    foliage.colours.leaf = o.leaf;
    foliage.colours.second = scene::shifted_colour(o.leaf, 1.15F);
    foliage.colours.variety = 0.2F;
    species.leaves = make_foliage(skeleton, foliage, seed.child("leaves"));
    species.masses = crown_masses(species.leaves, kThinCrown);
    add_fringe(species.masses);
    species.leaf = leaf_picture(foliage.kind, seed.child("leaf"));
    species.foliage = foliage_picture(foliage.kind, seed.child("leaf"));
    species.bark_colour = o.bark;
    species.height_m = o.height_m;
    species.crown_radius_m = 0.3F * o.height_m;
    species.trunk_radius_m = kTrunk * o.height_m;
    return species;
}

}  // namespace quadrat::synthesis::trees
