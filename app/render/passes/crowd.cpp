// SPDX-License-Identifier: Apache-2.0
#include "render/passes/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "render/passes/air.hpp"
#include "render/passes/canopy.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr float kSeedling = 0.07F;
constexpr float kLowPlant_m = 2.2F;    // below this it is undergrowth, which fades out long before a tree does
constexpr float kBladesA_px2 = 0.22F;  // of a plant as high as wide, where all that is asked for is drawn
constexpr std::size_t kFewestBlades = 4;
constexpr float kFewestBladesA_px = 0.15F;  // of its height: large blades that are few are flags
constexpr float kLeastStand = 0.3F;    // of plants that are but a few blades: the fewest that stand for all of them
constexpr float kStem_px = 6;          // high; of a smaller tree with leaves it is left out
constexpr float kStemWidth_px = 1.3F;  // at least
constexpr float kWidenedAt = 1.6F;     // times as far away as where the coarsest wood begins
constexpr float kBareStem_px = 0.7F;   // where no crown joins it: a dead wood is no palisade
constexpr float kStandsFrom_px = 44;   // high; larger ones stand for themselves
constexpr float kStandsTo_px = 24;
constexpr float kMergedFrom = 0.40F;  // share of its blades with which a crown begins to become one mass
constexpr float kMergedTo = 0.15F;
constexpr float kMergedFrom_px = 260;  // and how high it is then
constexpr float kMergedTo_px = 120;
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
constexpr float kMassFringed = 13;          // and with much detail as rough as leaves are: a smooth bush is a ball
constexpr float kBladesFineness = 0.012F;   // nor what is never a mass: a handful of its blades are flags
constexpr float kFewestOverMass = 12;       // blades; fewer are left out
constexpr float kLargestBlade_px = 8;       // of those that a crown's size would allow to be larger
// Blades that would have to be enlarged by so much, and are so long on the screen, are shards in a thin crown, which is
// better one mass without them where little is drawn of anything.
constexpr float kShardsFrom = 2.8F;
constexpr float kShardsTo = 4.5F;
constexpr float kShardsFrom_fineness = 0.1F;
constexpr float kShardsTo_fineness = 0.05F;
constexpr float kShardsFrom_px = 6;
constexpr float kShardsTo_px = 11;
constexpr float kLeastClear = 0.05F;
constexpr float kUsual_px = 90;  // high, of a tree that has its share of triangles
constexpr float kLeastNear = 0.6F;
constexpr float kMostNear = 5;
constexpr float kHiddenFrom = 0.07F;  // of a plant's clear share: what shows less dwindles
constexpr float kHiddenTo = 0.02F;    // and is gone
constexpr float kCanopy_px = 10;      // a lower crown hides too little to be worth reckoning
constexpr float kLeaving = 1.5F;      // a level begins to become the next with so many times the triangles asked for
constexpr float kLimb_px = 1.3F;      // as thick are limbs that begin to be missed
constexpr float kShape_px = 11;       // a shorter blade shows no more than that it is one

using Seen = Sight::Seen;

float leafiness(float fineness) { return std::min(std::sqrt(fineness / kLeafyFrom), 1.0F); }

// Of a plant in a picture that is drawn smaller than it is shown. Where there is enough for all, it has as much as
// ever.
float drawn_px(const Seen& seen, float scale, float fineness) {
    return seen.worth_px * std::pow(scale, 1 - leafiness(fineness));
}

std::size_t wood_triangles(const Kind& kind, const Closeness& how) {
    return how.wood_level < kind.wood_triangles.size() ? kind.wood_triangles[how.wood_level] : 0;
}

// A batch's prefix is the next half power of two above what its plants want.
int leaf_bucket(float share) { return std::max(0, static_cast<int>(std::floor(-2 * std::log2(share)))); }

std::size_t prefix(const Kind& kind, int bucket) {
    const float share = std::exp2(-0.5F * static_cast<float>(bucket));
    const auto blades = static_cast<std::size_t>(std::ceil(static_cast<float>(kind.blades) * share));
    return std::min(kind.blades, std::max(blades, kFewestBlades));
}

// A plant's place in an order of all that is even in any part of it, 0 to 1: plants that lie side by side are
// neighbours.
float rank_of(std::uint32_t plant) {
    const auto turned = static_cast<std::uint32_t>(plant * 2654435769U);  // 2^32 / the golden ratio
    return static_cast<float>(turned >> 8U) * 0x1p-24F;
}

// How much of a plant is left when so many stand for all: those about to leave shrink first.
float kept(std::uint32_t plant, float stand) {
    constexpr float kShrinking = 0.15F;
    return std::clamp((1 + kShrinking - rank_of(plant) / stand) / kShrinking, 0.0F, 1.0F);
}

std::size_t triangles_of(const Kind& kind, const Closeness& how) {
    const std::size_t blades = how.has_leaves ? prefix(kind, leaf_bucket(how.share)) : 0;
    const std::size_t mass = how.mass_level < kind.mass_triangles.size() ? kind.mass_triangles[how.mass_level] : 0;
    return wood_triangles(kind, how) + mass +
           blades * (how.is_plain ? kind.triangles_per_plain_blade : kind.triangles_per_blade);
}

// Of plants so high on the screen: near by none is left out, and none larger than it is for those that are.
float least_stand(float height_px) {
    const float near = std::clamp((height_px - kStandsTo_px) / (kStandsFrom_px - kStandsTo_px), 0.0F, 1.0F);
    return kLeastStand + (1 - kLeastStand) * near;
}

// However few stand for all of its kind, and however large their blades.
bool is_hidden(const scene::Plant& plant, const Kind& kind, float height_px, const Gathering& g) {
    if (!g.horizon) return false;
    constexpr float kBladesBeyond = 1.25F;
    const float size = kBladesBeyond * plant.scale / std::sqrt(least_stand(height_px * g.scale));
    return g.horizon->hides_standing({plant.root_m.x, plant.root_m.z}, kind.radius_m * size,
                                     plant.root_m.y + kind.height_m * size);
}

float fineness_at(int step, const Gathering& g) { return g.fineness * static_cast<float>(step) / kSteps; }

Closeness closeness_of(const Kind& kind, const Seen& seen, const Gathering& g, float fineness) {
    return closeness(kind, drawn_px(seen, g.scale, fineness), fineness);
}

// Counted until they are more than `enough`.
std::size_t triangles_at(int step, const Crowding& view, std::size_t enough) {
    const Gathering& g = *view.gathering;
    const float fineness = fineness_at(step, g);
    std::size_t sum = 0;
    for (const Seen& s : view.sight->seen) {
        const Kind& kind = view.kinds[s.species];
        const Closeness how = closeness_of(kind, s, g, fineness);
        if (kept(s.plant, how.stand) > 0) sum += triangles_of(kind, how);
        if (sum > enough) break;
    }
    return sum;
}

glm::u8vec4 bytes_of(const glm::vec4& shares) {
    return {unsigned_byte(shares.x), unsigned_byte(shares.y), unsigned_byte(shares.z), unsigned_byte(shares.w)};
}

// Gusts travel over the land; twigs of a tall tree move further. Metres at the tips, east and south.
glm::vec2 wind_m(const scene::Plant& plant, float height_m, float seconds) {
    const float phase = 0.9F * seconds - 0.021F * plant.root_m.x - 0.013F * plant.root_m.z;
    const float reach_m = 0.028F * height_m * (0.55F + 0.45F * std::sin(0.37F * phase));
    const float swing = std::sin(1.7F * phase + plant.yaw_rad);
    return reach_m * glm::vec2{0.6F + 0.4F * swing, 0.35F * std::cos(1.3F * phase + plant.yaw_rad)};
}

Instance instance_of(const scene::Plant& plant, const Kind& kind, const Seen& seen, const Closeness& how,
                     const Gathering& g) {
    const float age = grown(g.growth, plant.delay);
    const float height_m = kind.height_m * plant.scale;
    const glm::vec3 middle_m = plant.root_m + glm::vec3{0, 0.5F * height_m, 0};
    // Leaves between the eye and the sun glow.
    const glm::vec3 look = glm::normalize(middle_m - glm::vec3{g.view.eye_seconds} + glm::vec3{0, 0, 1e-4F});
    const float against = std::max(glm::dot(look, glm::vec3{g.view.to_sun}), 0.0F);
    const float sun = plant.sun * (g.clouds ? cloud_light_at(g.view, *g.clouds, middle_m) : 1);
    const float through = 0.9F * against * against * against * sun;
    const glm::vec2 wind = wind_m(plant, height_m, g.view.eye_seconds.w);
    // Lighter and yellower, or darker and bluer.
    const glm::vec3 tint = g.tint * (1.0F + plant.tint * glm::vec3{0.24F, 0.16F, -0.10F});
    const float size = plant.scale * seen.shown * kept(seen.plant, how.stand) / std::sqrt(how.stand);
    return {{plant.root_m, size * (0.25F + 0.75F * age)},
            {std::sin(plant.yaw_rad), std::cos(plant.yaw_rad), age, how.share},
            {wind.x, wind.y, sun, through},
            bytes_of(haze_at(g.view, middle_m)),
            bytes_of({0.5F * tint, 1 / how.enlarged}),
            bytes_of({how.to_coarser, how.mass_to_coarser, how.merged, how.mass_size})};
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

// 0 from, 1 at to and beyond.
float between(float from, float to, float value) { return std::clamp((value - from) / (to - from), 0.0F, 1.0F); }

// How far a crown is one mass: none of it while it is large on the screen, or its blades are many.
float merged_crown(float share, float height_px, float leafy) {
    return between(kMergedFrom, kMergedTo, share) *
           between(kMergedFrom_px, kMergedTo_px, height_px * std::max(leafy, kLeastLeafy));
}

// A crown so small is its mass or its blades, not both; where little is drawn of anything, also one whose mass stands
// for little of it.
float one_or_the_other_px(const Kind& kind, float leafy) {
    return kind.massed >= kMassAlone ? kMass_px : kMass_px * (1 - leafy);
}

// What the coarsest wood is to become, for its stem to be seen.
float widened(const Kind& kind, float m_a_px) {
    const float trunk_m = std::max(kind.trunk_m, 1e-3F);
    const float wide_px = kBareStem_px + (kStemWidth_px - kBareStem_px) * std::min(2 * kind.opacity, 1.0F);
    return std::clamp((0.5F * wide_px * m_a_px - trunk_m) / (kWidening * trunk_m), 0.0F, 1.0F);
}

bool is_mass_enough(const Kind& kind) {
    return kind.massed >= kMassAlone || (!kind.mass_triangles.empty() && kind.mass_triangles.back() <= kSimpleMass);
}

}  // namespace

float grown(float growth, float delay) {
    const float turn = 0.45F;  // of the arrival, from a plant's first leaf to its last
    const float t = std::clamp((growth - delay * (1 - turn)) / turn, 0.0F, 1.0F);
    const float eased = t * t * (3 - 2 * t);
    return kSeedling + (1 - kSeedling) * eased;
}

Closeness closeness(const Kind& kind, float height_px, float fineness) {
    Closeness how;
    const bool has_leaves = how.has_leaves = kind.blades > 0;
    const float m_a_px = kind.height_m / std::max(height_px, 1e-3F);
    const float allowed_m = kLimb_px * m_a_px / std::sqrt(fineness);
    const Level wood = level_leaving_out(kind.wood_left_out_m, allowed_m);
    how.wood_level = wood.at;
    how.to_coarser = wood.to_coarser;
    if (how.wood_level + 1 >= kind.wood_triangles.size() && !kind.wood_left_out_m.empty())
        how.to_coarser =
            widened(kind, m_a_px) * between(1, kWidenedAt, allowed_m / std::max(kind.wood_left_out_m.back(), 1e-3F));
    // The stem of so small a crown is not missed.
    if (has_leaves && height_px < kStem_px) how.wood_level = kind.wood_triangles.size();
    if (!has_leaves) return how;
    const float least = kind.mass_triangles.empty() ? kBladesFineness : 0;
    const float fewest = std::min(static_cast<float>(kind.blades),
                                  std::max(static_cast<float>(kFewestBlades), kFewestBladesA_px * height_px));
    const float all = static_cast<float>(kind.blades);
    float wanted_blades = std::max(fineness, least) * kBladesA_px2 * height_px * height_px;
    const auto share_of = [&](float blades) { return std::clamp(blades, fewest, all) / all; };
    const float blade_px = kind.blade_m * height_px / std::max(kind.height_m, 0.1F);
    // Large ones near by are seen as what they are, sooner than in a crown that is small.
    const float largest = std::clamp(kLargestBlade_px / blade_px, 0.55F * kind.largest_blade, kind.largest_blade);
    const auto enlarged_by = [&](float blades) { return std::min(1 / std::sqrt(share_of(blades)), largest); };
    how.enlarged = enlarged_by(wanted_blades);
    how.mass_level = kind.mass_triangles.size();
    const float leafy = leafiness(fineness);
    const float shards = kind.mass_triangles.empty()
                             ? 0
                             : between(kShardsFrom, kShardsTo, 1 / std::sqrt(share_of(wanted_blades))) *
                                   between(kShardsFrom_px, kShardsTo_px, blade_px * how.enlarged) *
                                   between(kShardsFrom_fineness, kShardsTo_fineness, fineness);
    const float merged =
        kind.mass_triangles.empty() ? 0 : std::max(merged_crown(share_of(wanted_blades), height_px, leafy), shards);
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
        // The stem behind it is at its coarsest, which becomes nothing coarser.
        if (how.wood_level < kind.wood_triangles.size()) how.wood_level = kind.wood_triangles.size() - 1;
        how.to_coarser = widened(kind, m_a_px);
        wanted_blades *= 1 - kLeavesMerged * kind.massed * merged;
        how.enlarged = enlarged_by(wanted_blades);
        wanted_blades *= 1 - shards;
        const bool is_bare = merged > 0.9F && wanted_blades < kFewestOverMass && fineness < kLeafyFrom;
        how.has_leaves = height_px > small_px ? !is_bare : !is_mass_enough(kind);
    }
    how.share = share_of(wanted_blades);
    how.stand = std::clamp(wanted_blades / fewest, least_stand(height_px), 1.0F);
    how.is_plain =
        kind.triangles_per_plain_blade > 0 && blade_px * std::sqrt(std::sqrt(fineness / how.share)) < kShape_px;
    return how;
}

namespace {

// The upper seven tenths of a plant of this height, as it is grown.
Canopy::Box crown_box(const scene::Plant& plant, const Kind& kind, const Gathering& g) {
    const float size = plant.scale * (0.25F + 0.75F * grown(g.growth, plant.delay));
    const float height_m = kind.height_m * size;
    const glm::mat4& clip = g.view.clip_from_world;
    const glm::vec4 middle = clip * glm::vec4{plant.root_m + glm::vec3{0, 0.65F * height_m, 0}, 1};
    const glm::vec4 up = clip * glm::vec4{0, 0.35F * height_m, 0, 0};
    const float per_w = 1 / std::max(middle.w, 0.5F);
    const glm::vec2 at = glm::vec2{middle} * per_w;
    const glm::vec2 rise = glm::vec2{up} * per_w;
    // Across the picture a metre is as long as the projection's first two rows are.
    const glm::vec2 metre{glm::length(glm::vec3{clip[0].x, clip[1].x, clip[2].x}),
                          glm::length(glm::vec3{clip[0].y, clip[1].y, clip[2].y})};
    const glm::vec2 wide = kind.crown_m * size * per_w * metre;
    const bool is_upright = std::abs(rise.y) >= std::abs(rise.x);
    const glm::vec2 half = is_upright ? glm::vec2{wide.x, std::abs(rise.y)} : glm::vec2{std::abs(rise.x), wide.y};
    return {at - half, at + half};
}

// What is large is looked at: it has more than its share of the picture's triangles.
float near_share(float height_px) { return std::clamp(height_px / kUsual_px, kLeastNear, kMostNear); }

// From near to far. What is half hidden needs fewer triangles; not half as many, for what shows of it shows whole.
void find_hidden(std::span<const scene::Plant> plants, std::span<const Kind> kinds, const Gathering& g, Sight& sight) {
    std::vector<std::pair<float, std::uint32_t>> order;
    order.reserve(sight.seen.size());
    for (std::size_t i = 0; i < sight.seen.size(); ++i) {
        const glm::vec3 off_m = plants[sight.seen[i].plant].root_m - glm::vec3{g.view.eye_seconds};
        order.emplace_back(glm::dot(off_m, off_m), static_cast<std::uint32_t>(i));
    }
    std::ranges::sort(order);
    Canopy canopy;
    for (const auto& [distance2, i] : order) {
        Seen& seen = sight.seen[i];
        const scene::Plant& plant = plants[seen.plant];
        const Kind& kind = kinds[plant.species];
        const Canopy::Box box = crown_box(plant, kind, g);
        const float clear = canopy.seen(box);
        seen.worth_px *= std::sqrt(near_share(seen.height_px) * std::sqrt(std::max(clear, kLeastClear)));
        seen.shown *= between(kHiddenTo, kHiddenFrom, clear);
        if (kind.opacity > 0 && seen.height_px >= kCanopy_px) canopy.add(box, kind.opacity * seen.shown);
    }
    sight.hidden += std::erase_if(sight.seen, [](const Seen& seen) { return seen.shown <= 0; });
}

}  // namespace

Sight look(std::span<const scene::Plant> plants, std::span<const Kind> kinds, const Frustum& frustum,
           const Gathering& g) {
    // Where less is drawn of everything, undergrowth is drawn less far.
    const float reach = std::min(std::sqrt(g.fineness), 1.0F);
    Sight sight;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        const scene::Plant& plant = plants[i];
        const Kind& kind = kinds[plant.species];
        if (!g.reach.holds_standing({plant.root_m.x, plant.root_m.z}, kind.radius_m * plant.scale)) continue;
        const float half_m = 0.5F * kind.height_m * plant.scale;
        const glm::vec3 middle_m = plant.root_m + glm::vec3{0, half_m, 0};
        const float distance_m = glm::length(middle_m - glm::vec3{g.view.eye_seconds});
        const float height_px = 2 * half_m * g.pixels_per_radian / std::max(distance_m, 0.5F);
        const bool is_low = kind.height_m < kLowPlant_m;
        const float shown =
            is_low ? glm::smoothstep(5.0F, 9.0F, height_px * reach) : glm::smoothstep(1.2F, 2.2F, height_px * reach);
        if (shown <= 0) continue;
        if (!frustum.may_see_sphere(middle_m, std::hypot(half_m, kind.radius_m * plant.scale))) continue;
        if (is_hidden(plant, kind, height_px, g)) {
            ++sight.hidden;
            continue;
        }
        sight.seen.push_back({static_cast<std::uint32_t>(i), plant.species, height_px, height_px, shown});
    }
    find_hidden(plants, kinds, g, sight);
    return sight;
}

// Counting is monotone in the steps: from a guess, twice as far each time until the answer lies between two of them,
// then half as far.
int affordable_step(std::span<const Crowding> views, std::size_t triangle_budget, std::optional<int> guess) {
    const auto fits = [&](int step) {
        std::size_t left = triangle_budget;
        for (const Crowding& view : views) {
            const auto enough = static_cast<std::size_t>(static_cast<float>(left) / view.share);
            const auto takes =
                static_cast<std::size_t>(view.share * static_cast<float>(triangles_at(step, view, enough)));
            if (takes > left) return false;
            left -= takes;
        }
        return true;
    };
    int least = 0;  // fits, or nothing does
    int too_many = kSteps + 1;
    const auto ask = [&](int step) { (fits(step) ? least : too_many) = step; };
    if (!guess) ask(kSteps);
    int next = std::clamp(guess.value_or(0), 0, kSteps);
    for (int stride = 1; least < next && next < too_many; stride *= 2) {
        ask(next);
        next = least == next ? std::min(next + stride, kSteps) : std::max(next - stride, 0);
    }
    while (too_many - least > 1) ask((least + too_many) / 2);
    return least;
}

Crowd gather(std::span<const scene::Plant> plants, std::span<const Kind> kinds, Sight sight, int step,
             const Gathering& gathering, std::vector<Instance>& instances) {
    Crowd crowd;
    std::vector<Seen>& seen = sight.seen;
    crowd.fineness = fineness_at(step, gathering);
    // By species, then large to small: every level's plants lie side by side, nearest first.
    std::ranges::sort(seen, [](const Seen& a, const Seen& b) {
        if (a.species != b.species) return a.species < b.species;
        return a.worth_px != b.worth_px ? a.worth_px > b.worth_px : a.plant < b.plant;
    });
    const auto extend = [&](const Batch& batch) {
        for (Batch& last : crowd.batches) {
            const bool is_same = last.species == batch.species && last.part == batch.part &&
                                 last.level == batch.level && last.blades == batch.blades &&
                                 last.is_plain == batch.is_plain;
            if (is_same) {
                ++last.count;
                return;
            }
        }
        crowd.batches.push_back(batch);
    };
    for (const Seen& s : seen) {
        const Kind& kind = kinds[s.species];
        const Closeness how = closeness_of(kind, s, gathering, crowd.fineness);
        if (kept(s.plant, how.stand) <= 0) continue;
        const std::size_t at = instances.size();
        instances.push_back(instance_of(plants[s.plant], kind, s, how, gathering));
        if (how.wood_level < kind.wood_triangles.size())
            extend({s.species, Batch::Part::Wood, how.wood_level, 0, false, at, 1});
        if (how.mass_level < kind.mass_triangles.size())
            extend({s.species, Batch::Part::Mass, how.mass_level, 0, false, at, 1});
        if (how.has_leaves)
            extend({s.species, Batch::Part::Leaves, 0, prefix(kind, leaf_bucket(how.share)), how.is_plain, at, 1});
        crowd.triangles += triangles_of(kind, how);
    }
    return crowd;
}

}  // namespace quadrat::render::passes
