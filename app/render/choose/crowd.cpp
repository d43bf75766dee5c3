// SPDX-License-Identifier: Apache-2.0
#include "render/choose/crowd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "render/choose/air.hpp"
#include "render/choose/bytes.hpp"
#include "render/choose/canopy.hpp"
#include "render/choose/cloud_light.hpp"

namespace quadrat::render::choose {
namespace {

constexpr float kSeedling = 0.07F;
constexpr float kLowPlant_m = 2.2F;  // below this it is undergrowth, which fades out long before a tree does
constexpr float kLeastClear = 0.05F;
constexpr float kLeastInside = 0.22F;  // of a crown's box: what is at the picture's edge is near
constexpr float kUsual_px = 90;        // high, of a tree that has its share of triangles
constexpr float kLeastNear = 0.6F;
constexpr float kMostNear = 4;
constexpr float kHiddenFrom = 0.07F;   // of a plant's clear share: what shows less dwindles
constexpr float kHiddenTo = 0.02F;     // and is gone
constexpr std::size_t kSubjects = 2;   // of a picture, at most: plants that are larger than the next one,
constexpr float kSubjectFrom = 1.05F;  // by so much,
constexpr float kSubjectTo = 1.35F;
constexpr float kSubjectFrom_px = 60;  // and so large
constexpr float kSubjectTo_px = 110;
constexpr float kCanopy_px = 10;  // a lower crown hides too little to be worth reckoning

using Seen = Sight::Seen;

// Of a plant in a picture that is drawn smaller than it is shown. Where there is enough for all, it has as much as
// ever.
float drawn_px(const Seen& seen, float scale, float fineness) {
    return seen.worth_px * std::pow(scale, 1 - leafiness(fineness));
}

std::size_t wood_triangles(const PlantKind& kind, const Closeness& how) {
    return how.wood_level < kind.wood_triangles.size() ? kind.wood_triangles[how.wood_level] : 0;
}

// A batch's prefix is the next half power of two above what its plants want.
int leaf_bucket(float share) { return std::max(0, static_cast<int>(std::floor(-2 * std::log2(share)))); }

std::size_t prefix(const PlantKind& kind, int bucket) {
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

// Of that copy of its blades, 0 the blades themselves.
float share_of_copy(const Closeness& how, std::size_t copy) {
    return std::clamp(how.share - static_cast<float>(copy), 0.0F, 1.0F);
}

std::size_t copies_of(const Closeness& how) {
    return how.has_leaves ? std::max(static_cast<std::size_t>(std::ceil(how.share)), std::size_t{1}) : 0;
}

std::size_t triangles_of(const PlantKind& kind, const Closeness& how) {
    std::size_t blades = 0;
    for (std::size_t copy = 0; copy < copies_of(how); ++copy)
        blades += prefix(kind, leaf_bucket(share_of_copy(how, copy)));
    const std::size_t mass = how.mass_level < kind.mass_triangles.size() ? kind.mass_triangles[how.mass_level] : 0;
    return wood_triangles(kind, how) + mass +
           blades * (how.is_plain ? kind.triangles_per_plain_blade : kind.triangles_per_blade);
}

// However few stand for all of its kind, and however large their blades.
bool is_hidden(const scene::Plant& plant, const PlantKind& kind, float height_px, const Gathering& g) {
    if (!g.horizon) return false;
    constexpr float kBladesBeyond = 1.25F;
    const float size = kBladesBeyond * plant.scale / std::sqrt(least_stand(height_px * g.scale));
    return g.horizon->hides_standing({plant.root_m.x, plant.root_m.z}, kind.radius_m * size,
                                     plant.root_m.y + kind.height_m * size);
}

float fineness_at(int step, const Gathering& g) { return g.fineness * static_cast<float>(step) / kSteps; }

Closeness closeness_of(const PlantKind& kind, const Seen& seen, const Gathering& g, float fineness) {
    return closeness(kind, drawn_px(seen, g.scale, fineness), fineness, seen.looked_at);
}

// Counted until they are more than `enough`.
std::size_t triangles_at(int step, const Crowding& view, std::size_t enough) {
    const Gathering& g = *view.gathering;
    const float fineness = fineness_at(step, g);
    std::size_t sum = 0;
    for (const Seen& s : view.sight->seen) {
        const PlantKind& kind = view.kinds[s.species];
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

Instance instance_of(const scene::Plant& plant, const PlantKind& kind, const Seen& seen, const Closeness& how,
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
            {std::sin(plant.yaw_rad), std::cos(plant.yaw_rad), age, share_of_copy(how, 0)},
            {wind.x, wind.y, sun, through},
            bytes_of(haze_at(g.view, middle_m)),
            bytes_of({0.5F * tint, kLeastBlade / how.enlarged}),
            bytes_of({how.to_coarser, how.mass_to_coarser, how.merged, how.mass_size})};
}

}  // namespace

float grown(float growth, float delay) {
    const float turn = 0.45F;  // of the arrival, from a plant's first leaf to its last
    const float t = std::clamp((growth - delay * (1 - turn)) / turn, 0.0F, 1.0F);
    const float eased = t * t * (3 - 2 * t);
    return kSeedling + (1 - kSeedling) * eased;
}

namespace {

// The upper seven tenths of a plant of this height, as it is grown.
Canopy::Box crown_box(const scene::Plant& plant, const PlantKind& kind, const Gathering& g) {
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

// Of a box, the share that lies in the picture.
float inside_picture(const Canopy::Box& box) {
    const glm::vec2 low = glm::max(box.low, glm::vec2{-1});
    const glm::vec2 high = glm::min(box.high, glm::vec2{1});
    const glm::vec2 share = glm::max(high - low, glm::vec2{0}) / glm::max(box.high - box.low, glm::vec2{1e-6F});
    return share.x * share.y;
}

// From near to far. What is half hidden needs fewer triangles; not half as many, for what shows of it shows whole.
void find_hidden(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, const Gathering& g,
                 Sight& sight) {
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
        const PlantKind& kind = kinds[plant.species];
        const Canopy::Box box = crown_box(plant, kind, g);
        const float clear = canopy.seen(box);
        // What lies outside the picture needs none at all, but a crown's leaves are all of one size.
        const float inside = std::max(inside_picture(box), kLeastInside);
        seen.worth_px *= std::sqrt(near_share(seen.height_px) * inside * std::sqrt(std::max(clear, kLeastClear)));
        seen.shown *= between(kHiddenTo, kHiddenFrom, clear);
        if (kind.opacity > 0 && seen.height_px >= kCanopy_px) canopy.add(box, kind.opacity * seen.shown);
    }
    sight.hidden += std::erase_if(sight.seen, [](const Seen& seen) { return seen.shown <= 0; });
}

// Continuous in what each plant is worth: none becomes a subject, or ceases to be one, from one frame to the next.
void find_subjects(std::span<const PlantKind> kinds, Sight& sight) {
    std::array<Seen*, kSubjects + 1> largest{};  // largest first
    for (Seen& seen : sight.seen) {
        if (kinds[seen.species].height_m < kLowPlant_m) continue;
        Seen* smaller = &seen;
        for (Seen*& place : largest)
            if (smaller && (!place || place->worth_px < smaller->worth_px)) std::swap(place, smaller);
    }
    const float next_px = largest.back() ? largest.back()->worth_px : 0;
    for (std::size_t i = 0; i < kSubjects && largest[i]; ++i) {
        Seen& seen = *largest[i];
        seen.looked_at = between(kSubjectFrom * next_px, kSubjectTo * next_px + 1e-3F, seen.worth_px) *
                         between(kSubjectFrom_px, kSubjectTo_px, seen.worth_px);
    }
}

}  // namespace

Sight look(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, const Frustum& frustum,
           const Gathering& g) {
    // Where less is drawn of everything, undergrowth is drawn less far.
    const float reach = std::min(std::sqrt(g.fineness), 1.0F);
    Sight sight;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        const scene::Plant& plant = plants[i];
        const PlantKind& kind = kinds[plant.species];
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
    find_subjects(kinds, sight);
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

namespace {

// One of several draws of a plant's blades: an instance of its own.
struct Copy {
    Instance instance;
    Batch batch;
};

void add_copies(std::vector<Copy>& copies, const Seen& s, const PlantKind& kind, const Closeness& how,
                Instance instance) {
    for (std::size_t number = 1; number < copies_of(how); ++number) {
        const float share = share_of_copy(how, number);
        instance.turn_grown_share.w = share;
        const Batch batch{s.species, Batch::Part::Leaves, 0, prefix(kind, leaf_bucket(share)), how.is_plain, number, 0,
                          1};
        copies.push_back({instance, batch});
    }
}

// To one that it follows, or by itself.
void add_batch(std::vector<Batch>& batches, const Batch& batch) {
    for (Batch& last : batches) {
        const bool is_same = last.species == batch.species && last.part == batch.part && last.level == batch.level &&
                             last.blades == batch.blades && last.is_plain == batch.is_plain && last.copy == batch.copy;
        if (!is_same || last.first + last.count != batch.first) continue;
        ++last.count;
        return;
    }
    batches.push_back(batch);
}

}  // namespace

Crowd gather(std::span<const scene::Plant> plants, std::span<const PlantKind> kinds, Sight sight, int step,
             const Gathering& gathering, std::vector<Instance>& instances) {
    Crowd crowd;
    std::vector<Seen>& seen = sight.seen;
    crowd.fineness = fineness_at(step, gathering);
    // By species, then large to small: every level's plants lie side by side, nearest first.
    std::ranges::sort(seen, [](const Seen& a, const Seen& b) {
        if (a.species != b.species) return a.species < b.species;
        return a.worth_px != b.worth_px ? a.worth_px > b.worth_px : a.plant < b.plant;
    });
    std::vector<Copy> copies;
    for (const Seen& s : seen) {
        const PlantKind& kind = kinds[s.species];
        const Closeness how = closeness_of(kind, s, gathering, crowd.fineness);
        if (kept(s.plant, how.stand) <= 0) continue;
        const std::size_t at = instances.size();
        instances.push_back(instance_of(plants[s.plant], kind, s, how, gathering));
        if (how.wood_level < kind.wood_triangles.size())
            add_batch(crowd.batches, {s.species, Batch::Part::Wood, how.wood_level, 0, false, 0, at, 1});
        if (how.mass_level < kind.mass_triangles.size())
            add_batch(crowd.batches, {s.species, Batch::Part::Mass, how.mass_level, 0, false, 0, at, 1});
        if (how.has_leaves) {
            const std::size_t blades = prefix(kind, leaf_bucket(share_of_copy(how, 0)));
            add_batch(crowd.batches, {s.species, Batch::Part::Leaves, 0, blades, how.is_plain, 0, at, 1});
        }
        add_copies(copies, s, kind, how, instances.back());
        crowd.triangles += triangles_of(kind, how);
    }
    // After all plants, so that those have no gaps; of one number side by side, so that they are few batches.
    std::ranges::stable_sort(copies, {}, [](const Copy& copy) {
        return std::pair{copy.batch.species, copy.batch.copy};
    });
    for (Copy& copy : copies) {
        copy.batch.first = instances.size();
        instances.push_back(copy.instance);
        add_batch(crowd.batches, copy.batch);
    }
    return crowd;
}

}  // namespace quadrat::render::choose
