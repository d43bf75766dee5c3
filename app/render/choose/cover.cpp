// SPDX-License-Identifier: Apache-2.0
#include "render/choose/cover.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "render/choose/air.hpp"
#include "render/choose/bytes.hpp"
#include "render/choose/cloud_light.hpp"

namespace quadrat::render::choose {
namespace {

constexpr float kWhole_m = 4.4F;  // to this distance, in a quarter of a screen of 1080 lines, all blades are drawn
constexpr float kUsual_px = 703;  // pixels per radian there

// Of a wave of turns of 2 pi: near enough to a sine, for what sways.
float wave(float turns) {
    const float t = turns - std::floor(turns) - 0.5F;
    return 8 * t * (1 - 2 * std::abs(t));
}

// Gusts travel over the land, with eddies in them.
float gust_at(const glm::vec3& at_m, float seconds) {
    const float turns = 0.30F * seconds - 0.037F * at_m.x - 0.027F * at_m.z;
    return (wave(turns) + 0.6F * wave(2.3F * turns + 0.31F * at_m.x)) / 1.6F;
}

float nearest_m(const scene::Sward::Cell& cell, const glm::vec3& eye_m) {
    return glm::distance(eye_m, glm::clamp(eye_m, cell.low_m, cell.high_m));
}

float whole_m(const CoverWish& wish) { return kWhole_m * wish.pixels_per_radian / kUsual_px * wish.whole; }

// To where the shader draws it in.
float reach_m(const CoverOfScene& cover, const CoverWish& wish) { return cover.reach_m * wish.drawn_to; }

// Of a tuft's blades, those that are drawn.
float share_at(float distance, float whole) {
    const float share = std::min(whole / std::max(distance, 1e-3F), 1.0F);
    return share * std::sqrt(share);
}

// In this view, through its air and under its clouds.
CoverInstance seen(const CoverTuft& tuft, const CoverWish& wish, float whole, float ends_m, float grown) {
    const glm::vec4 haze = haze_at(*wish.view, tuft.root_m);
    const float clouds = wish.clouds ? cloud_light_at(*wish.view, *wish.clouds, tuft.root_m) : 1;
    const float clear = wish.view->sunlight.w * (1 - haze.a) * clouds;
    const float distance_m = glm::distance(tuft.root_m, wish.eye_m());
    const float ending = std::clamp(3.2F - 3.2F * distance_m / ends_m, 0.0F, 1.0F);
    const float widened = 1 / std::sqrt(std::max(share_at(distance_m, whole), 1e-4F));
    CoverInstance instance{tuft.root_m,
                           {glm::packHalf1x16(tuft.turn_m.x), glm::packHalf1x16(tuft.turn_m.y),
                            glm::packHalf1x16(tuft.height_m * ending * grown), glm::packHalf1x16(widened)},
                           tuft.ground_lit,
                           {}};
    for (std::uint8_t& byte : instance.ground_lit)
        byte = static_cast<std::uint8_t>(std::min(static_cast<float>(byte) * clear + 0.5F, 255.0F));
    for (int c = 0; c < 3; ++c) instance.veil_gust[static_cast<std::size_t>(c)] = unsigned_byte(haze[c] * haze.a);
    instance.veil_gust[3] = unsigned_byte(0.5F + 0.5F * gust_at(tuft.root_m, wish.view->eye_seconds.w));
    return instance;
}

// Shares are grouped by half powers of two, so that few batches serve all.
constexpr int kBuckets = 9;
int bucket_of(float share) { return std::clamp(static_cast<int>(std::floor(-2 * std::log2(share))), 0, kBuckets - 1); }
float share_of(int bucket) { return std::exp2(-0.5F * static_cast<float>(bucket)); }

}  // namespace

CoverSeen look_at_cover(const CoverOfScene& cover, const Frustum& frustum, const CoverWish& wish) {
    struct Seen {
        std::size_t cell;
        int bucket;
    };
    std::vector<Seen> cells;
    const float whole = whole_m(wish);
    const float reach = reach_m(cover, wish);
    for (std::size_t i = 0; i < cover.cells.size(); ++i) {
        const scene::Sward::Cell& cell = cover.cells[i];
        const float distance = nearest_m(cell, wish.eye_m());
        if (distance < reach && wish.reach.may_hold_box(cell.low_m, cell.high_m) &&
            frustum.may_see_box(cell.low_m, cell.high_m))
            cells.push_back({i, bucket_of(share_at(distance, whole))});
    }
    const float grown = 0.1F + 0.9F * glm::smoothstep(0.0F, 0.7F, wish.growth);
    CoverSeen shown;
    for (std::size_t kind = 0; kind < scene::kCoverKinds; ++kind) {
        for (int bucket = 0; bucket < kBuckets; ++bucket) {
            const bool is_stone = kind == static_cast<std::size_t>(scene::CoverKind::Stone);
            const auto all = static_cast<float>(kCoverParts[kind].count);
            const auto parts = static_cast<std::size_t>(std::ceil(all * (is_stone ? 1 : share_of(bucket))));
            CoverSeen::Batch batch{static_cast<scene::CoverKind>(kind), parts, shown.instances.size(), 0};
            for (const Seen& s : cells) {
                if (s.bucket != bucket) continue;
                const scene::Sward::Cell& cell = cover.cells[s.cell];
                std::size_t first = cell.first;
                for (std::size_t k = 0; k < kind; ++k) first += cell.counts[k];
                for (std::size_t i = first; i < first + cell.counts[kind]; ++i)
                    if (wish.reach.holds_standing({cover.tufts[i].root_m.x, cover.tufts[i].root_m.z}, 0))
                        shown.instances.push_back(seen(cover.tufts[i], wish, whole, reach, grown));
            }
            batch.count = shown.instances.size() - batch.first;
            if (batch.count == 0) continue;
            shown.triangles += batch.count * parts * static_cast<std::size_t>(kCoverParts[kind].triangles);
            shown.batches.push_back(batch);
        }
    }
    return shown;
}

}  // namespace quadrat::render::choose
