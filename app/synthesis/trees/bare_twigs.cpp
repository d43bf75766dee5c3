// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/bare_twigs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"
#include "synthesis/trees/foliage.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kPerCrown = 190;     // twigs, of a crown of a metre's radius; of larger ones by their mantle
constexpr float kPerLeafless = 420;  // where each is but a triangle
constexpr float kThin = 0.020F;      // half a twig's width, to its length
constexpr float kLengths = 0.17F;    // of a twig, to the crown's radius
constexpr float kShortest_m = 0.18F;
constexpr float kFollows = 1.6F;  // how much a twig goes the way of an undrawn limb that is as long
constexpr float kSlack = 0.2F;    // as which of the limbs it begins on may be farther than the nearest

glm::vec3 across(const glm::vec3& along) {
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    return glm::normalize(glm::cross(along, other));
}

glm::vec3 direction(base::RandomStream& random) {
    const glm::vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    return v / std::max(glm::length(v), 0.1F);
}

// As of leaves: what is farther along the limbs appears later.
float age_at(const TreeSkeleton& skeleton, float path_m) {
    const float along = std::min(path_m / std::max(skeleton.longest_path_m, 1.0e-3F), 1.0F);
    return std::min(0.12F + 0.83F * along, 1.0F);
}

float sway_at(const TreeSkeleton& skeleton, const Site& site) {
    return std::clamp(skeleton.limbs[site.limb].nodes[site.node].sway, 0.0F, 1.0F);
}

constexpr std::size_t kPiecesALimb = 3;  // so many follow its curve closely enough
constexpr float kThinnest = 0.011F;      // half a bough's width, to the limb's length: thinner ones are dots from afar

// A piece of a limb.
struct Bough {
    const Limb* limb;
    std::size_t from, to;  // nodes
    float strength;
};

float length_m(const Limb& limb) { return glm::length(limb.nodes.back().at_m - limb.nodes.front().at_m); }

std::vector<Bough> boughs_of(const TreeSkeleton& skeleton) {
    std::vector<Bough> boughs;
    for (const Limb& limb : skeleton.limbs) {
        if (limb.order == 0 || length_m(limb) <= 0) continue;
        const std::size_t last = limb.nodes.size() - 1;
        const std::size_t pieces = std::min(kPiecesALimb, last);
        for (std::size_t n = 0; n < pieces; ++n) {
            const std::size_t from = last * n / pieces;
            boughs.push_back({&limb, from, last * (n + 1) / pieces, limb.nodes[from].radius_m * length_m(limb)});
        }
    }
    std::ranges::stable_sort(boughs, std::greater{}, &Bough::strength);
    return boughs;
}

void add_boughs(scene::Leaves& leaves, const TreeSkeleton& skeleton, const glm::vec3& bark, std::size_t most) {
    std::vector<Bough> boughs = boughs_of(skeleton);
    boughs.resize(std::min(boughs.size(), most));
    const glm::vec3 middle_m = 0.5F * (skeleton.low_m + skeleton.high_m);
    for (const Bough& bough : boughs) {
        const Limb::Node& foot = bough.limb->nodes[bough.from];
        const glm::vec3 way_m = bough.limb->nodes[bough.to].at_m - foot.at_m;
        BladeShape blade;
        blade.site_m = foot.at_m;
        blade.length_m = glm::length(way_m);
        if (blade.length_m <= 0) continue;
        blade.along = way_m / blade.length_m;
        blade.face = across(blade.along);
        blade.half_width_m = std::max(foot.radius_m, kThinnest * length_m(*bough.limb));
        // What tapers to a point within the limb goes on where the next piece begins.
        blade.length_m *= 1.25F;
        blade.fold_m = 0;
        scene::Leaves::Vertex vertex;
        vertex.normal = glm::normalize(glm::vec3{foot.at_m.x - middle_m.x, 0.4F, foot.at_m.z - middle_m.z});
        vertex.colour = bark;
        vertex.shade = 0.85F;
        vertex.age = age_at(skeleton, foot.path_m);
        vertex.sway = std::clamp(foot.sway, 0.0F, 1.0F);
        add_blade(leaves, sliver_shape(), blade, vertex);
    }
}

void add_twigs(scene::Leaves& leaves, const TreeSkeleton& skeleton, const std::vector<const Site*>& bare,
               const BareCrown& crown, float per_crown, const LeafShape& shape, std::size_t most, base::Seed seed) {
    const float share = static_cast<float>(bare.size()) / static_cast<float>(skeleton.sites.size());
    const float wanted = per_crown * share * std::max(crown.radius_m, 0.4F);
    const std::size_t count = std::min(static_cast<std::size_t>(wanted), most);
    const glm::vec3 middle_m = 0.5F * (skeleton.low_m + skeleton.high_m);
    const glm::vec3 half_m = glm::max(0.5F * (skeleton.high_m - skeleton.low_m), glm::vec3{0.2F});
    for (std::size_t i = 0; i < count; ++i) {
        base::RandomStream random{base::Seed{base::hash_of(seed, 0, static_cast<std::int64_t>(i))}};
        // By chance, so that a prefix has twigs of the whole crown.
        const Site& site = *bare[random.below(static_cast<std::uint32_t>(bare.size()))];
        const glm::vec3 outward = (site.at_m - middle_m) / half_m;
        const glm::vec3 out = outward / std::max(glm::length(outward), 0.1F);
        const float usual_m = std::max(kLengths * crown.radius_m, kShortest_m);
        BladeShape twig;
        twig.site_m = crown.wood != nullptr ? crown.wood->nearest(site.at_m, 0, kSlack).at_m : site.at_m;
        // Along the limb that is not drawn, if there is one.
        const glm::vec3 undrawn = kFollows * (site.at_m - twig.site_m) / usual_m;
        twig.along = glm::normalize(undrawn + site.along + 0.5F * site.out + 0.35F * out + 0.45F * direction(random) +
                                    glm::vec3{0, 0.2F, 0});
        twig.face = across(twig.along);
        twig.length_m = usual_m * random.between(0.6F, 1.3F);
        twig.half_width_m = kThin * twig.length_m;
        twig.fold_m = 0;
        twig.bow_m = 0.35F * twig.length_m * random.between(-1, 1);
        scene::Leaves::Vertex vertex;
        vertex.normal = glm::normalize(out + 0.5F * twig.face + glm::vec3{0, 0.25F, 0});
        vertex.colour = scene::shifted_colour(crown.bark, random.between(0.95F, 1.15F));
        vertex.shade = 0.85F;
        vertex.age = age_at(skeleton, site.path_m);
        vertex.sway = sway_at(skeleton, site);
        add_blade(leaves, shape, twig, vertex);
    }
}

}  // namespace

scene::Leaves bare_twigs(const TreeSkeleton& skeleton, const BareCrown& crown, const LeafShape& shape, std::size_t most,
                         base::Seed seed) {
    scene::Leaves twigs;
    std::vector<const Site*> bare;
    for (const Site& site : skeleton.sites)
        if (site.organ == Organ::None) bare.push_back(&site);
    if (!bare.empty()) add_twigs(twigs, skeleton, bare, crown, kPerCrown, shape, most, seed);
    return twigs;
}

scene::Leaves leafless_crown(const TreeSkeleton& skeleton, const BareCrown& crown, std::size_t most, base::Seed seed) {
    scene::Leaves leaves;
    add_boughs(leaves, skeleton, crown.bark, most / 2);
    std::vector<const Site*> all;
    for (const Site& site : skeleton.sites) all.push_back(&site);
    const std::size_t left = most - leaves.blades;
    if (!all.empty()) add_twigs(leaves, skeleton, all, crown, kPerLeafless, sliver_shape(), left, seed);
    return leaves;
}

namespace {

constexpr std::array<std::size_t, 3> kStrokes{72, 30, 12};  // a level
constexpr float kStrokesCover = 0.30F;                      // of the crown, seen from aside
constexpr float kStrokesStandFor = 0.75F;                   // of all twigs
constexpr float kWidest = 0.22F;                            // of a stroke, to its length

// Of a dead tree, that has no place for a leaf.
std::vector<Site> along_limbs(const TreeSkeleton& skeleton) {
    std::vector<Site> sites;
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
        const Limb& limb = skeleton.limbs[i];
        if (limb.order == 0 || length_m(limb) <= 0) continue;
        const glm::vec3 along = (limb.nodes.back().at_m - limb.nodes.front().at_m) / length_m(limb);
        const std::size_t last = limb.nodes.size() - 1;
        for (const std::size_t node : {last, (last + 1) / 2}) {
            const Limb::Node& at = limb.nodes[node];
            sites.push_back({at.at_m, along, across(along), at.path_m, static_cast<int>(i), static_cast<int>(node)});
        }
    }
    return sites;
}

struct Stroke {
    glm::vec3 foot_m;  // where what bears it leaves the trunk: it does not float beside that
    glm::vec3 tip_m, side, normal;
    float age, sway;
};

// Where a limb, or what it grows on, leaves the trunk.
glm::vec3 at_trunk_m(const TreeSkeleton& skeleton, const Site& site) {
    const Limb* limb = &skeleton.limbs[static_cast<std::size_t>(site.limb)];
    if (limb->order == 0) return limb->nodes[static_cast<std::size_t>(std::max(site.node - 1, 0))].at_m;
    while (limb->order > 1 && limb->parent >= 0) limb = &skeleton.limbs[static_cast<std::size_t>(limb->parent)];
    return limb->nodes.front().at_m;
}

Stroke stroke_at(const TreeSkeleton& skeleton, const Site& site, base::RandomStream random) {
    const glm::vec3 middle_m = 0.5F * (skeleton.low_m + skeleton.high_m);
    Stroke stroke;
    stroke.foot_m = at_trunk_m(skeleton, site);
    stroke.tip_m = site.at_m + 1.0e-2F * site.along;
    const glm::vec3 along = glm::normalize(stroke.tip_m - stroke.foot_m + 1.0e-4F * site.along);
    stroke.side =
        glm::normalize(glm::cross(along, direction(random) + glm::vec3{0, 1.0e-3F, 0}) + 1.0e-4F * across(along));
    stroke.normal = glm::normalize(glm::vec3{site.at_m.x - middle_m.x, 0.5F, site.at_m.z - middle_m.z});
    stroke.age = age_at(skeleton, site.path_m);
    stroke.sway = sway_at(skeleton, site);
    return stroke;
}

std::array<glm::vec3, 3> corners(const Stroke& stroke, float area_m2) {
    const float length_m = glm::distance(stroke.foot_m, stroke.tip_m);
    const float width_m = std::min(2 * area_m2 / std::max(length_m, 1.0e-3F), kWidest * length_m);
    return {stroke.foot_m - 0.5F * width_m * stroke.side, stroke.foot_m + 0.5F * width_m * stroke.side, stroke.tip_m};
}

}  // namespace

std::vector<scene::CrownMass> leafless_masses(const TreeSkeleton& skeleton, const BareCrown& crown, base::Seed seed) {
    std::vector<scene::CrownMass> masses;
    const std::vector<Site> sites = skeleton.sites.empty() ? along_limbs(skeleton) : skeleton.sites;
    if (sites.empty()) return masses;
    float low_m = skeleton.high_m.y;
    for (const Site& site : sites) low_m = std::min(low_m, site.at_m.y);
    const float crown_m2 = kStrokesCover * 1.6F * crown.radius_m * std::max(skeleton.high_m.y - low_m, 0.5F);
    for (std::size_t level = 0; level < kStrokes.size(); ++level) {
        scene::CrownMass& mass = masses.emplace_back();
        const float area_m2 = crown_m2 / static_cast<float>(kStrokes[level]);
        for (std::size_t i = 0; i < kStrokes[level]; ++i) {
            base::RandomStream random{base::Seed{base::hash_of(seed, 1, static_cast<std::int64_t>(i))}};
            const Site& site = sites[random.below(static_cast<std::uint32_t>(sites.size()))];
            const Stroke stroke = stroke_at(skeleton, site, random);
            const auto now = corners(stroke, area_m2);
            for (std::size_t k = 0; k < now.size(); ++k) {
                mass.mesh.indices.push_back(static_cast<std::uint32_t>(mass.mesh.positions_m.size()));
                mass.mesh.positions_m.push_back(now[k]);
                mass.mesh.normals.push_back(stroke.normal);
                mass.colours.push_back(crown.bark);
                mass.shades.push_back(0.85F);
                mass.ages.push_back(stroke.age);
                mass.sways.push_back(stroke.sway);
                if (level + 1 == kStrokes.size()) continue;
                const bool stays = i < kStrokes[level + 1];
                const auto then = corners(stroke, crown_m2 / static_cast<float>(kStrokes[level + 1]));
                mass.coarser_m.push_back(stays ? then[k] : stroke.foot_m);
            }
        }
        mass.sprays = kStrokes[level];
        mass.share = kStrokesStandFor;
    }
    return masses;
}

}  // namespace quadrat::synthesis::trees
