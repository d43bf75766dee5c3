// SPDX-License-Identifier: Apache-2.0
#include "render/choose/closeness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace quadrat::render::choose {
namespace {

constexpr float kBladesA_px2 = 0.22F;  // of a plant as high as wide, where all that is asked for is drawn
constexpr float kSlivers = 10;  // of a triangle each stand for a blade of many: it is no dearer, and they are thin
constexpr float kCopiesWanted = 0.16F;  // of the blades that are asked for and are not there, those that copies are
constexpr float kCopied = -0.30F;  // a copy's size to their number, to this power: together they hide more of the limbs
constexpr float kFewestBladesA_px = 0.15F;  // of its height: large blades that are few are flags
constexpr float kFewestFronds = 0.45F;      // of a palm's: with four of them it is a stake
constexpr float kLargestFrond = 1.5F;       // times its size, where so few stand for all
constexpr float kLeastStand = 0.3F;    // of plants that are but a few blades: the fewest that stand for all of them
constexpr float kStem_px = 6;          // high; of a smaller tree with leaves it is left out
constexpr float kStemWidth_px = 1.3F;  // at least
constexpr float kWidenedAt = 1.6F;     // times as far away as where the coarsest wood begins
constexpr float kBareStem_px = 0.7F;   // where no crown joins it: a dead wood is no palisade
constexpr float kThinTrunk_px = 0.8F;  // its radius; of a leafless crown that is thinner the stem is widened
constexpr float kStandsFrom_px = 44;   // high; larger ones stand for themselves
constexpr float kStandsTo_px = 24;
constexpr float kMassStandsFrom_px = 22;  // the same of a crown that is one mass
constexpr float kMassStandsTo_px = 6;
constexpr float kMergedFrom = 0.40F;  // share of its blades with which a crown begins to become one mass
constexpr float kMergedTo = 0.15F;
constexpr float kMergedFrom_px = 260;  // and how high it is then
constexpr float kMergedTo_px = 120;
// A crown of any size whose blades cover so much less than all of them do lets its stem be seen: a mass fills it.
constexpr float kCoveredFrom = 0.6F;
constexpr float kCoveredTo = 0.3F;
constexpr float kLeastLeafy = 0.7F;
constexpr float kLeavesMerged = 0.55F;   // of the blades are not needed then
constexpr float kMassA_px2 = 0.15F;      // triangles, of a plant as high as wide
constexpr float kMass_px = 13;           // of a tree so small no more is seen
constexpr float kMassAlone = 0.7F;       // of its leaves, where its mass stands for so many
constexpr std::size_t kSimpleMass = 16;  // triangles: no more than the blades that would be seen instead
// With less fineness than this larger crowns merge too: four blades that stand for thousands are shards.
constexpr float kLeafyFrom = 0.125F;
constexpr float kMassOutline = 9;           // triangles at least, times its height in pixels to this power:
constexpr float kMassOutlinePower = 0.75F;  // its outline is smooth at any size,
constexpr float kMassFringed = 26;          // and with much detail as rough as leaves are: a smooth bush is a ball
constexpr float kBladesFineness = 0.012F;   // nor what is never a mass: a handful of its blades are flags
constexpr float kSliversFineness = 0.02F;   // nor a leafless crown: a handful of its twigs float about it
constexpr float kLimbsFineness = 0.03F;     // nor what has no crown but its limbs: without them it is a post
constexpr float kFewestOverMass = 12;       // blades; fewer are left out
constexpr float kMadeUpFor = 1.2F;          // a blade's size that makes up for those left out near by
constexpr float kLargestBlade_px = 8;       // of those that a crown's size would allow to be larger
// Blades that would have to be enlarged by so much, and are so long on the screen, are shards in a thin crown, which is
// better one mass without them where little is drawn of anything.
constexpr float kShardsFrom = 2.8F;
constexpr float kShardsTo = 4.5F;
constexpr float kShardsFrom_fineness = 0.1F;
constexpr float kShardsTo_fineness = 0.05F;
constexpr float kShardsFrom_px = 6;
constexpr float kShardsTo_px = 11;
constexpr float kLeaving = 1.5F;    // a level begins to become the next with so many times the triangles asked for
constexpr float kLimb_px = 1.3F;    // as thick are limbs that begin to be missed
constexpr float kShape_px = 11;     // a shorter blade shows no more than that it is one
constexpr float kFewestNear = 360;  // blades, of a crown near by,
constexpr float kFewestNearShare = 0.7F;  // or this share of all
constexpr float kWoodNear = 0.2F;         // and has limbs that bear them, as with this fineness
constexpr float kWoodBeside = 0.4F;       // of that, where it is not what is looked at
constexpr float kNearFrom_px = 200;       // as high, and more so than it is where it is large on the screen
constexpr float kNearTo_px = 500;
constexpr float kTall_m = 6;         // of lower plants, so much less:
constexpr float kLeastTall = 0.25F;  // of those sizes

// A bush is near where it is not as high on the screen as a tree.
float nearness(const PlantKind& kind, float height_px, float looked_at) {
    const float tall = kind.mass_triangles.empty() ? 1 : std::clamp(kind.height_m / kTall_m, kLeastTall, 1.0F);
    return std::max(between(kNearFrom_px * tall, kNearTo_px * tall, height_px), looked_at);
}

// Of a part's levels, finest first.
struct Level {
    std::size_t at = 0;
    float to_coarser = 0;
};

// The finest level within so many triangles; it becomes the next one as they dwindle to its own.
Level level_within(const std::vector<std::size_t>& triangles, float wanted) {
    for (std::size_t level = 0; level + 1 < triangles.size(); ++level) {
        const auto own = static_cast<float>(triangles[level]);
        if (own > wanted) continue;
        const float finer = level > 0 ? static_cast<float>(triangles[level - 1]) : own * kLeaving;
        const float begins = std::min(own * kLeaving, finer);
        return {level, begins > own ? std::clamp((begins - wanted) / (begins - own), 0.0F, 1.0F) : 0.0F};
    }
    return {triangles.empty() ? 0 : triangles.size() - 1};
}

// The coarsest level that leaves out no more than so much ("Genetic selection of parametric scenes" 2003, section 6.2:
// D = alpha E^beta, of which a thickness in metres makes beta 1); it becomes the next one as that comes to be as much.
Level level_leaving_out(const std::vector<float>& left_out_m, float allowed_m) {
    std::size_t level = left_out_m.empty() ? 0 : left_out_m.size() - 1;
    while (level > 0 && left_out_m[level] > allowed_m) --level;
    if (level + 1 >= left_out_m.size()) return {level};
    const float next_m = left_out_m[level + 1];
    const float begins_m = std::max(next_m / kLeaving, left_out_m[level]);
    return {level, std::clamp((allowed_m - begins_m) / (next_m - begins_m), 0.0F, 1.0F)};
}

// How far a crown is one mass: none of it while it is large on the screen, or its blades are many.
float merged_crown(float share, float height_px, float leafy) {
    return between(kMergedFrom, kMergedTo, share) *
           between(kMergedFrom_px, kMergedTo_px, height_px * std::max(leafy, kLeastLeafy));
}

// How far blades, of which a share stands for all, would be shards of so many pixels.
float shards_of(const PlantKind& kind, float share, float blade_px, float fineness) {
    if (kind.mass_triangles.empty()) return 0;
    return between(kShardsFrom, kShardsTo, 1 / std::sqrt(share)) * between(kShardsFrom_px, kShardsTo_px, blade_px) *
           between(kShardsFrom_fineness, kShardsTo_fineness, fineness);
}

// A crown so small is its mass or its blades, not both; where little is drawn of anything, also one whose mass stands
// for little of it.
float one_or_the_other_px(const PlantKind& kind, float leafy) {
    return kind.massed >= kMassAlone ? kMass_px : kMass_px * (1 - leafy);
}

// What the coarsest wood is to become, for its stem to be seen.
float widened(const PlantKind& kind, float m_a_px) {
    const float trunk_m = std::max(kind.trunk_m, 1e-3F);
    const float wide_px = kBareStem_px + (kStemWidth_px - kBareStem_px) * std::min(2 * kind.opacity, 1.0F);
    return std::clamp((0.5F * wide_px * m_a_px - trunk_m) / (kWidening * trunk_m), 0.0F, 1.0F);
}

bool is_mass_enough(const PlantKind& kind) {
    return kind.massed >= kMassAlone || (!kind.mass_triangles.empty() && kind.mass_triangles.back() <= kSimpleMass);
}

// Its blades are as long as its crown is wide, on a stem, and nothing fills in for those that are left out.
bool is_palm(const PlantKind& kind) {
    const bool has_stem = !kind.wood_triangles.empty() && kind.wood_triangles.front() > 0;
    return has_stem && kind.mass_triangles.empty() && kind.largest_blade <= 1;
}

// How much larger than it is a blade may be drawn.
float largest_blade(const PlantKind& kind, float blade_px) {
    if (is_palm(kind)) return kLargestFrond;
    const float least = kind.mass_triangles.empty() ? 1 : kMadeUpFor;
    const float most = std::max(kind.largest_blade, least);
    // Large ones near by are seen as what they are, sooner than in a crown that is small.
    return std::clamp(kLargestBlade_px / blade_px, std::max(0.55F * most, least), most);
}

// A crown that is looked at is leaves, whatever is drawn of all others: one mass so near is a hedgehog on a pole.
float fewest_blades(const PlantKind& kind, float height_px, float nearness) {
    const float near = std::max(kFewestNear, kFewestNearShare * static_cast<float>(kind.blades));
    const float palm = is_palm(kind) ? kFewestFronds * static_cast<float>(kind.blades) : 0;
    const float fewest =
        std::max({static_cast<float>(kFewestBlades), kFewestBladesA_px * height_px, near * nearness, palm});
    return std::min(static_cast<float>(kind.blades), fewest);
}

// Of a blade, where a share of them stands for all, or copies do.
float size_for(float share) { return std::pow(share, share > 1 ? kCopied : -0.5F); }

// A crown that is one mass needs no others of its kind to stand for, but where it is a speck.
float least_stand_of_masses(float height_px) {
    return kLeastStand + (1 - kLeastStand) * between(kMassStandsTo_px, kMassStandsFrom_px, height_px);
}

void set_wood(Closeness& how, const PlantKind& kind, float height_px, float fineness, float nearness) {
    const float m_a_px = kind.height_m / std::max(height_px, 1e-3F);
    const bool is_all_limbs = kind.are_slivers || kind.mass_triangles.empty();
    const float least = std::max(kWoodNear * nearness, is_all_limbs ? kLimbsFineness : 0);
    const float allowed_m = kLimb_px * m_a_px / std::sqrt(std::max(fineness, least));
    const Level wood = level_leaving_out(kind.wood_left_out_m, allowed_m);
    how.wood_level = wood.at;
    how.to_coarser = wood.to_coarser;
    if (how.wood_level + 1 >= kind.wood_triangles.size() && !kind.wood_left_out_m.empty())
        how.to_coarser =
            widened(kind, m_a_px) * between(1, kWidenedAt, allowed_m / std::max(kind.wood_left_out_m.back(), 1e-3F));
    // The stem of so small a crown is not missed.
    if (how.has_leaves && height_px < kStem_px) how.wood_level = kind.wood_triangles.size();
}

}  // namespace

float leafiness(float fineness) { return std::min(std::sqrt(fineness / kLeafyFrom), 1.0F); }

float least_stand(float height_px) {
    return kLeastStand + (1 - kLeastStand) * between(kStandsTo_px, kStandsFrom_px, height_px);
}

float between(float from, float to, float value) { return std::clamp((value - from) / (to - from), 0.0F, 1.0F); }

Closeness closeness(const PlantKind& kind, float height_px, float fineness, float looked_at) {
    Closeness how;
    how.has_leaves = kind.blades > 0;
    const float near = nearness(kind, height_px, looked_at);
    set_wood(how, kind, height_px, fineness, std::max(kWoodBeside * near, looked_at));
    if (!how.has_leaves) return how;
    const float m_a_px = kind.height_m / std::max(height_px, 1e-3F);
    const float least = kind.are_slivers ? kSliversFineness : kind.mass_triangles.empty() ? kBladesFineness : 0;
    const float fewest = fewest_blades(kind, height_px, near);
    const float all = static_cast<float>(kind.blades);
    const float worth = kind.are_slivers ? kSlivers : 1;
    float wanted_blades = worth * std::max(fineness, least) * kBladesA_px2 * height_px * height_px;
    const auto share_of = [&](float blades) {
        const float copied = all + kCopiesWanted * std::max(blades - all, 0.0F);
        return std::clamp(std::min(blades, copied), fewest, static_cast<float>(kind.copies) * all) / all;
    };
    const float blade_px = kind.blade_m * height_px / std::max(kind.height_m, 0.1F);
    const float largest = largest_blade(kind, blade_px);
    const auto enlarged_by = [&](float blades) { return std::min(size_for(share_of(blades)), largest); };
    how.enlarged = enlarged_by(wanted_blades);
    how.mass_level = kind.mass_triangles.size();
    const float leafy = leafiness(fineness);
    const float shards = shards_of(kind, share_of(wanted_blades), blade_px * how.enlarged, fineness);
    const float covered = share_of(wanted_blades) * how.enlarged * how.enlarged;
    const float merged = kind.mass_triangles.empty()
                             ? 0
                             : std::max({merged_crown(share_of(wanted_blades), height_px, leafy), shards,
                                         between(kCoveredFrom, kCoveredTo, covered)});
    const float small_px = one_or_the_other_px(kind, leafy);
    if (!is_mass_enough(kind) && small_px > 0) how.mass_size = between(small_px, 1.5F * small_px, height_px);
    if (merged > 0 && how.mass_size > 0) {
        const float broad = std::max(1.4F * kind.crown_m / std::max(kind.height_m, 0.1F), 1.0F);
        const float wanted =
            std::max(fineness * kMassA_px2 * height_px * height_px,
                     glm::mix(kMassOutline, kMassFringed, leafy) * broad * std::pow(height_px, kMassOutlinePower));
        const Level mass = level_within(kind.mass_triangles, wanted);
        how.mass_level = mass.at;
        how.mass_to_coarser = mass.to_coarser;
        how.merged = merged;
        // The stem behind it is at its coarsest, which becomes nothing coarser; near by it would stand beside a crown
        // that leans. Strokes hide none.
        if (near <= 0 && (!kind.are_slivers || kind.trunk_m < kThinTrunk_px * m_a_px)) {
            if (how.wood_level < kind.wood_triangles.size()) how.wood_level = kind.wood_triangles.size() - 1;
            how.to_coarser = widened(kind, m_a_px);
        }
        wanted_blades *= 1 - kLeavesMerged * kind.massed * merged;
        how.enlarged = enlarged_by(wanted_blades);
        wanted_blades *= 1 - shards;
        const bool is_bare = merged > 0.9F && wanted_blades < kFewestOverMass && fineness < kLeafyFrom;
        how.has_leaves = height_px > small_px ? !is_bare : !is_mass_enough(kind);
    }
    how.share = share_of(wanted_blades);
    how.stand = std::clamp(wanted_blades / fewest, least_stand(height_px), 1.0F);
    how.stand = std::max(how.stand, how.merged * least_stand_of_masses(height_px));
    how.is_plain =
        kind.triangles_per_plain_blade > 0 &&
        blade_px * std::sqrt(std::sqrt(std::max(std::max(fineness, least) / how.share, looked_at))) < kShape_px;
    return how;
}

}  // namespace quadrat::render::choose
