// SPDX-License-Identifier: Apache-2.0
#include "render/passes/cover.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "base/seed.hpp"
#include "render/passes/air.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"

namespace quadrat::render::passes {
namespace {

constexpr float kTurn_rad = 6.2831853F;
constexpr float kGoldenAngle_rad = 2.3999632F;
constexpr float kWhole_m = 5.5F;  // to this distance, in a quarter of a screen of 1080 lines, all blades are drawn
constexpr float kUsual_px = 703;  // pixels per radian there
constexpr float kMostRadius_m = 2;
constexpr std::size_t kVerticesPerBlade = 3;
constexpr float kGust = 0.16F;  // of a blade's height

struct CoverVertex {
    glm::vec3 at;
    glm::vec3 aside;
    std::uint8_t tone, accent;
    std::uint16_t rank;
};

// Blades of one kind in shuffled order: the golden angle spreads any prefix evenly.
class Tufts {
  public:
    explicit Tufts(std::uint64_t seed, int blades, std::vector<CoverVertex>& to)
        : blades_(blades), random_(base::Seed{seed}), to_(to) {}

    glm::vec2 foot(int i) const {
        const float radius = std::sqrt((static_cast<float>((i * 7) % blades_) + 0.5F) / static_cast<float>(blades_));
        const float turn = kGoldenAngle_rad * static_cast<float>(i);
        return radius * glm::vec2{std::cos(turn), std::sin(turn)};
    }
    base::RandomStream& random() { return random_; }

    void vertex(int i, const glm::vec3& at, const glm::vec3& aside, float tone, float accent = 0) {
        const float rank = static_cast<float>(i) / static_cast<float>(blades_);
        to_.push_back({at, aside, unsigned_byte(0.5F * tone), unsigned_byte(accent),
                       static_cast<std::uint16_t>(65535.0F * rank)});
    }

  private:
    int blades_;
    base::RandomStream random_;
    std::vector<CoverVertex>& to_;
};

glm::vec2 any_way(base::RandomStream& random) {
    const float turn = random.between(0, kTurn_rad);
    return {std::cos(turn), std::sin(turn)};
}

constexpr int kGrassBlades = 34;
void add_grass(std::vector<CoverVertex>& to) {
    Tufts tufts(0x67'72'61'73, kGrassBlades, to);
    for (int i = 0; i < kGrassBlades; ++i) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = tufts.foot(i);
        const glm::vec2 way = any_way(random);
        const glm::vec2 tip = 0.82F * foot + random.between(0.25F, 0.75F) * any_way(random);
        const float high = random.between(0.55F, 1.1F);
        const glm::vec3 aside = random.between(0.022F, 0.040F) * glm::vec3{way.x, 0, way.y};
        const float tone = random.between(0.84F, 1.16F);
        tufts.vertex(i, {foot.x, 0, foot.y}, -aside, 0.50F * tone);
        tufts.vertex(i, {foot.x, 0, foot.y}, aside, 0.56F * tone);
        tufts.vertex(i, {tip.x, high, tip.y}, glm::vec3{0}, 1.38F * tone);
    }
}

constexpr int kCushionLeaves = 26;
void add_cushion(std::vector<CoverVertex>& to) {
    Tufts tufts(0x63'75'73'68, kCushionLeaves, to);
    for (int i = 0; i < kCushionLeaves; ++i) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = 0.9F * tufts.foot(i);
        // Over a dome: those in the middle stand, those at the rim lie.
        const float dome = 1 - 0.75F * glm::dot(foot, foot);
        const glm::vec2 out = 0.30F * foot + 0.25F * any_way(random);
        const glm::vec2 way = any_way(random);
        const glm::vec3 aside = random.between(0.14F, 0.24F) * glm::vec3{way.x, 0.35F * random.between(-1, 1), way.y};
        const float tone = random.between(0.86F, 1.14F);
        tufts.vertex(i, {foot.x, 0.35F * dome, foot.y}, -aside, 0.72F * tone);
        tufts.vertex(i, {foot.x, 0.45F * dome, foot.y}, aside, 0.92F * tone);
        tufts.vertex(i, {foot.x + out.x, dome * random.between(0.75F, 1.1F), foot.y + out.y}, glm::vec3{0},
                     1.22F * tone);
    }
}

// Stems, each with a head of two triangles after it.
constexpr int kFlowerParts = 27;
void add_flowers(std::vector<CoverVertex>& to) {
    Tufts tufts(0x66'6C'6F'77, kFlowerParts, to);
    for (int i = 0; i < kFlowerParts; i += 3) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = tufts.foot(i);
        const glm::vec2 tip = 0.9F * foot + 0.35F * any_way(random);
        const float high = random.between(0.75F, 1.15F);
        const glm::vec2 way = any_way(random);
        const glm::vec3 aside = 0.03F * glm::vec3{way.x, 0, way.y};
        tufts.vertex(i, {foot.x, 0, foot.y}, -aside, 0.72F);
        tufts.vertex(i, {foot.x, 0, foot.y}, aside, 0.80F);
        tufts.vertex(i, {tip.x, high, tip.y}, glm::vec3{0}, 1.25F);
        const float size = random.between(0.085F, 0.13F);
        const glm::vec3 wide = size * glm::vec3{way.x, 0, way.y};
        const glm::vec3 deep = size * glm::vec3{-way.y, 0.75F, way.x};
        for (const float side : {-1.0F, 1.0F}) {
            const int part = i + (side < 0 ? 1 : 2);
            tufts.vertex(part, {tip.x, high, tip.y}, -wide, 1, 0.92F);
            tufts.vertex(part, {tip.x, high, tip.y}, wide, 1, 1);
            tufts.vertex(part, {tip.x, high, tip.y}, side * deep, 1, 0.72F);
        }
    }
}

// A stone of six facets, and two small ones beside it.
constexpr int kStoneFacets = 18;
void add_stones(std::vector<CoverVertex>& to) {
    Tufts tufts(0x73'74'6F'6E, kStoneFacets, to);
    int facet = 0;
    for (const glm::vec3 stone : {glm::vec3{0, 0, 1}, glm::vec3{1.9F, 0.8F, 0.5F}, glm::vec3{-1.1F, 1.7F, 0.38F}}) {
        base::RandomStream& random = tufts.random();
        const glm::vec3 top{stone.x + 0.25F * stone.z * random.between(-1, 1), stone.z * random.between(0.8F, 1.0F),
                            stone.y + 0.25F * stone.z * random.between(-1, 1)};
        std::array<glm::vec3, 6> rim;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const float turn = kTurn_rad * (static_cast<float>(k) + random.between(-0.3F, 0.3F)) / 6;
            const float out = stone.z * random.between(0.75F, 1.1F);
            rim[k] = {stone.x + out * std::cos(turn), -0.25F, stone.y + out * std::sin(turn)};
        }
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const float tone = 0.82F + 0.36F * static_cast<float>((k * 5) % 6) / 5;
            tufts.vertex(facet, rim[k], glm::vec3{0}, 0.72F * tone);
            tufts.vertex(facet, rim[(k + 1) % rim.size()], glm::vec3{0}, 0.72F * tone);
            tufts.vertex(facet, top, glm::vec3{0}, 1.15F * tone);
            ++facet;
        }
    }
}

constexpr std::array<int, scene::kCoverKinds> kBlades{kGrassBlades, kCushionLeaves, kFlowerParts, kStoneFacets};

CoverInstance instance_of(const scene::Tuft& tuft) {
    const glm::vec3 shown = encode(tuft.sent);
    return {tuft.root_m,
            {unsigned_byte(0.5F + 0.5F * std::cos(tuft.yaw_rad)), unsigned_byte(0.5F + 0.5F * std::sin(tuft.yaw_rad)),
             unsigned_byte(tuft.radius_m / kMostRadius_m), unsigned_byte(0.5F * tuft.height_m)},
            {unsigned_byte(shown.r), unsigned_byte(shown.g), unsigned_byte(shown.b), unsigned_byte(encode(tuft.lit))},
            {}};
}

// In this view, through its air and under its clouds.
CoverInstance seen_through_air(CoverInstance tuft, const CoverWish& wish) {
    const glm::vec4 haze = haze_at(*wish.view, tuft.root_m);
    const float clouds = wish.clouds ? cloud_light_at(*wish.view, *wish.clouds, tuft.root_m) : 1;
    const float clear = wish.view->sunlight.w * (1 - haze.a) * clouds;
    for (std::uint8_t& byte : tuft.ground_lit)
        byte = static_cast<std::uint8_t>(std::min(static_cast<float>(byte) * clear + 0.5F, 255.0F));
    for (int c = 0; c < 3; ++c) tuft.veil[static_cast<std::size_t>(c)] = unsigned_byte(haze[c] * haze.a);
    return tuft;
}

float nearest_m(const scene::Sward::Cell& cell, const glm::vec3& eye_m) {
    return glm::distance(eye_m, glm::clamp(eye_m, cell.low_m, cell.high_m));
}

float whole_m(const CoverWish& wish) {
    return kWhole_m * wish.pixels_per_radian / kUsual_px * std::min(std::sqrt(wish.alpha), 1.5F);
}

// To where the shader draws it in.
float reach_m(const CoverOfScene& cover, const CoverWish& wish) {
    return cover.reach_m * std::min(std::pow(wish.alpha, 0.3F), 1.0F);
}

// As the shader has it.
float share_at(float distance, float whole) {
    const float share = std::min(whole / std::max(distance, 1e-3F), 1.0F);
    return share * std::sqrt(share);
}

// Shares are grouped by half powers of two, so that few batches serve all.
constexpr int kBuckets = 9;
int bucket_of(float share) { return std::clamp(static_cast<int>(std::floor(-2 * std::log2(share))), 0, kBuckets - 1); }
float share_of(int bucket) { return std::exp2(-0.5F * static_cast<float>(bucket)); }

}  // namespace

void add_cover(gl::Slices& slices, CoverOfScene& cover, const std::shared_ptr<const scene::Scene>& source) {
    slices.prepare([&cover, source] {
        cover.cells = source->sward.cells;
        cover.blossom = source->sward.blossom;
        cover.reach_m = source->sward.reach_m;
        cover.tufts.reserve(source->sward.tufts.size());
        for (const scene::Tuft& tuft : source->sward.tufts) cover.tufts.push_back(instance_of(tuft));
    });
}

CoverPass::CoverPass()
    : program_("cover.vert", "lit.frag"),
      layout_{{0,
               sizeof(CoverVertex),
               gl::Advance::PerVertex,
               {{0, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(CoverVertex, at)},
                {1, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(CoverVertex, aside)},
                {2, 2, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(CoverVertex, tone)},
                {3, 1, GL_UNSIGNED_SHORT, gl::Numbers::Normalised, offsetof(CoverVertex, rank)}}},
              {1,
               sizeof(CoverInstance),
               gl::Advance::PerInstance,
               {{8, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(CoverInstance, root_m)},
                {9, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(CoverInstance, turn_size)},
                {10, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(CoverInstance, ground_lit)},
                {11, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(CoverInstance, veil)}}}} {
    std::vector<CoverVertex> vertices;
    std::size_t kind = 0;
    for (const auto make : {add_grass, add_cushion, add_flowers, add_stones}) {  // as scene::CoverKind names them
        first_vertices_[kind++] = vertices.size();
        make(vertices);
    }
    vertices_ = gl::Buffer{GL_ARRAY_BUFFER, vertices.size() * sizeof(CoverVertex)};
    vertices_.write<CoverVertex>(0, vertices);
}

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
    CoverSeen seen;
    for (std::size_t kind = 0; kind < scene::kCoverKinds; ++kind) {
        for (int bucket = 0; bucket < kBuckets; ++bucket) {
            const bool is_stone = kind == static_cast<std::size_t>(scene::CoverKind::Stone);
            const auto all = static_cast<float>(kBlades[kind]);
            const auto blades = static_cast<std::size_t>(std::ceil(all * (is_stone ? 1 : share_of(bucket))));
            CoverSeen::Batch batch{static_cast<scene::CoverKind>(kind), blades, seen.instances.size(), 0};
            for (const Seen& s : cells) {
                if (s.bucket != bucket) continue;
                const scene::Sward::Cell& cell = cover.cells[s.cell];
                std::size_t first = cell.first;
                for (std::size_t k = 0; k < kind; ++k) first += cell.counts[k];
                for (std::size_t i = first; i < first + cell.counts[kind]; ++i)
                    if (wish.reach.holds_standing({cover.tufts[i].root_m.x, cover.tufts[i].root_m.z}, 0))
                        seen.instances.push_back(seen_through_air(cover.tufts[i], wish));
            }
            batch.count = seen.instances.size() - batch.first;
            if (batch.count == 0) continue;
            seen.triangles += batch.count * blades;
            seen.batches.push_back(batch);
        }
    }
    return seen;
}

gl::Work CoverPass::draw(const CoverOfScene& cover, const CoverSeen& seen, const gl::StreamBuffer& instances,
                         const CoverWish& wish) const {
    if (seen.batches.empty()) return {};
    program_.use();
    const float grown = glm::smoothstep(0.0F, 0.7F, wish.growth);
    glUniform4f(0, whole_m(wish), 1 / reach_m(cover, wish), 0.1F + 0.9F * grown, kGust);
    const glm::vec3 blossom = encode(cover.blossom);
    glUniform4f(1, blossom.r, blossom.g, blossom.b, 0);
    layout_.bind();
    layout_.feed(0, vertices_.name());
    glDisable(GL_CULL_FACE);
    gl::Work work;
    for (const CoverSeen::Batch& batch : seen.batches) {
        layout_.feed(1, instances.name(), batch.first * sizeof(CoverInstance));
        const std::size_t vertices = batch.blades * kVerticesPerBlade;
        const std::size_t first = first_vertices_[static_cast<std::size_t>(batch.kind)];
        glDrawArraysInstanced(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(vertices),
                              static_cast<GLsizei>(batch.count));
        work += {1, batch.count * batch.blades, batch.count * vertices};
    }
    glEnable(GL_CULL_FACE);
    return work;
}

}  // namespace quadrat::render::passes
