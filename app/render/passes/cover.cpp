// SPDX-License-Identifier: Apache-2.0
#include "render/passes/cover.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <span>
#include <utility>

#include "base/seed.hpp"
#include "render/choose/air.hpp"
#include "render/gl/wires.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/packing.hpp"
#include "scene/night_eye.hpp"

namespace quadrat::render::passes {
namespace {

constexpr float kTurn_rad = 6.2831853F;
constexpr float kGoldenAngle_rad = 2.3999632F;
constexpr float kGust = 0.22F;  // of a blade's height, at most

constexpr const choose::CoverParts& parts_of(scene::CoverKind kind) {
    return choose::kCoverParts[static_cast<std::size_t>(kind)];
}

struct CoverVertex {
    glm::vec3 at;
    glm::vec3 aside;
    std::uint8_t tone, accent;
    std::uint16_t rank;
};

struct CoverMesh {
    std::vector<CoverVertex> vertices;
    std::vector<std::uint16_t> indices;
};

// Parts of one kind in shuffled order: the golden angle spreads any prefix evenly.
class Tufts {
  public:
    Tufts(std::uint64_t seed, int parts, CoverMesh& to) : parts_(parts), random_(base::Seed{seed}), to_(to) {}

    glm::vec2 foot(int part) const {
        const float radius = std::sqrt((static_cast<float>((part * 7) % parts_) + 0.5F) / static_cast<float>(parts_));
        const float turn = kGoldenAngle_rad * static_cast<float>(part);
        return radius * glm::vec2{std::cos(turn), std::sin(turn)};
    }
    base::RandomStream& random() { return random_; }

    // What follows belongs to this part.
    void begin(int part) {
        rank_ = static_cast<std::uint16_t>(65535.0F * static_cast<float>(part) / static_cast<float>(parts_));
        first_ = static_cast<std::uint16_t>(to_.vertices.size());
    }
    void vertex(const glm::vec3& at, const glm::vec3& aside, float tone, float accent = 0) {
        to_.vertices.push_back({at, aside, unsigned_byte(0.5F * tone), unsigned_byte(accent), rank_});
    }
    // Of the part's vertices.
    void triangle(int a, int b, int c) {
        for (const int k : {a, b, c}) to_.indices.push_back(static_cast<std::uint16_t>(first_ + k));
    }

  private:
    int parts_;
    base::RandomStream random_;
    CoverMesh& to_;
    std::uint16_t rank_ = 0;
    std::uint16_t first_ = 0;
};

glm::vec2 any_way(base::RandomStream& random) {
    const float turn = random.between(0, kTurn_rad);
    return {std::cos(turn), std::sin(turn)};
}

// Three blades side by side that share their feet: seven vertices instead of nine.
constexpr int kGrassRows = parts_of(scene::CoverKind::Grass).count;
constexpr int kBladesARow = parts_of(scene::CoverKind::Grass).triangles;
void add_grass(CoverMesh& to) {
    Tufts tufts(0x67'72'61'73, kGrassRows, to);
    for (int row = 0; row < kGrassRows; ++row) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = tufts.foot(row);
        const glm::vec2 way = any_way(random);
        const float width = random.between(0.065F, 0.11F);
        const float tone = random.between(0.86F, 1.14F);
        const glm::vec2 lean = random.between(0.10F, 0.45F) * any_way(random);
        tufts.begin(row);
        for (int k = 0; k <= kBladesARow; ++k) {
            const glm::vec2 out = width * (static_cast<float>(k) - 1.5F) * way;
            tufts.vertex({foot.x, 0, foot.y}, {out.x, 0, out.y}, (k % 2 == 0 ? 0.44F : 0.50F) * tone);
        }
        for (int k = 0; k < kBladesARow; ++k) {
            const glm::vec2 out = width * (static_cast<float>(k) - 1) * way;
            const glm::vec2 tip = 0.88F * foot + lean + random.between(0.10F, 0.40F) * any_way(random);
            const float light = random.between(0.92F, 1.08F);
            tufts.vertex({tip.x, random.between(0.55F, 1.1F), tip.y}, {out.x, 0, out.y}, 1.5F * tone * light);
            tufts.triangle(k, k + 1, kBladesARow + 1 + k);
        }
    }
}

constexpr int kCushionLeaves = parts_of(scene::CoverKind::Cushion).count;
void add_cushion(CoverMesh& to) {
    Tufts tufts(0x63'75'73'68, kCushionLeaves, to);
    for (int i = 0; i < kCushionLeaves; ++i) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = 0.9F * tufts.foot(i);
        // Over a dome: those in the middle stand, those at the rim lie.
        const float dome = 1 - 0.75F * glm::dot(foot, foot);
        const glm::vec2 out = 0.30F * foot + 0.25F * any_way(random);
        const glm::vec2 way = any_way(random);
        const glm::vec3 aside = random.between(0.13F, 0.24F) * glm::vec3{way.x, 0.35F * random.between(-1, 1), way.y};
        const float tone = random.between(0.86F, 1.14F);
        tufts.begin(i);
        tufts.vertex({foot.x, 0.35F * dome, foot.y}, -aside, 0.60F * tone);
        tufts.vertex({foot.x, 0.45F * dome, foot.y}, aside, 0.84F * tone);
        tufts.vertex({foot.x + out.x, dome * random.between(0.75F, 1.1F), foot.y + out.y}, glm::vec3{0}, 1.40F * tone);
        tufts.triangle(0, 1, 2);
    }
}

// Stems, each with a head of two triangles.
constexpr int kStems = parts_of(scene::CoverKind::Flower).count;
void add_flowers(CoverMesh& to) {
    Tufts tufts(0x66'6C'6F'77, kStems, to);
    for (int i = 0; i < kStems; ++i) {
        base::RandomStream& random = tufts.random();
        const glm::vec2 foot = tufts.foot(i);
        const glm::vec2 tip = 0.9F * foot + 0.35F * any_way(random);
        const glm::vec3 top{tip.x, random.between(0.75F, 1.15F), tip.y};
        const glm::vec2 way = any_way(random);
        const glm::vec3 aside = 0.028F * glm::vec3{way.x, 0, way.y};
        tufts.begin(i);
        tufts.vertex({foot.x, 0, foot.y}, -aside, 0.72F);
        tufts.vertex({foot.x, 0, foot.y}, aside, 0.80F);
        tufts.vertex(top, glm::vec3{0}, 1.25F);
        tufts.triangle(0, 1, 2);
        const float size = random.between(0.045F, 0.075F);
        const glm::vec3 wide = size * glm::vec3{way.x, 0, way.y};
        const glm::vec3 deep = size * glm::vec3{-way.y, 0.75F, way.x};
        tufts.vertex(top, -wide, 1, 0.92F);
        tufts.vertex(top, wide, 1, 1);
        tufts.vertex(top, -deep, 1, 0.72F);
        tufts.vertex(top, deep, 1, 0.78F);
        tufts.triangle(3, 4, 5);
        tufts.triangle(3, 4, 6);
    }
}

// A stone of five sides under a tilted top of three facets, and a small one beside it.
constexpr int kStones = parts_of(scene::CoverKind::Stone).count;
constexpr int kSides = 5;
static_assert(2 * kSides + kSides - 2 == parts_of(scene::CoverKind::Stone).triangles);
void add_stones(CoverMesh& to) {
    Tufts tufts(0x73'74'6F'6E, kStones, to);
    constexpr std::array<glm::vec3, kStones> kPlaces{{{0, 0, 1}, {1.7F, 0.9F, 0.48F}}};  // across, along, size
    using Ring = std::array<glm::vec3, kSides>;
    for (int i = 0; i < kStones; ++i) {
        const glm::vec3 stone = kPlaces[static_cast<std::size_t>(i)];
        base::RandomStream& random = tufts.random();
        Ring foot;
        Ring shoulder;
        const glm::vec2 tilt = 0.28F * any_way(random);
        for (std::size_t k = 0; k < kSides; ++k) {
            const float turn = kTurn_rad * (static_cast<float>(k) + random.between(-0.3F, 0.3F)) / kSides;
            const glm::vec2 way{std::cos(turn), std::sin(turn)};
            const glm::vec2 out = stone.z * random.between(0.8F, 1.1F) * way;
            const glm::vec2 in = random.between(0.35F, 0.75F) * out;
            foot[k] = {stone.x + out.x, -0.25F, stone.y + out.y};
            shoulder[k] = {stone.x + in.x, stone.z * (random.between(0.62F, 0.8F) + glm::dot(tilt, way)),
                           stone.y + in.y};
        }
        tufts.begin(i);
        int next = 0;
        const auto facet = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float low, float high) {
            tufts.vertex(a, glm::vec3{0}, low);
            tufts.vertex(b, glm::vec3{0}, low);
            tufts.vertex(c, glm::vec3{0}, high);
            tufts.triangle(next, next + 1, next + 2);
            next += 3;
        };
        for (std::size_t k = 0; k < kSides; ++k) {
            const std::size_t after = (k + 1) % kSides;
            const float tone = 0.84F + 0.30F * static_cast<float>((k * 3) % kSides) / (kSides - 1);
            facet(foot[k], foot[after], shoulder[k], 0.66F * tone, tone);
            facet(shoulder[after], shoulder[k], foot[after], tone, 0.66F * tone);
        }
        for (std::size_t k = 1; k + 1 < kSides; ++k)
            facet(shoulder[0], shoulder[k], shoulder[k + 1], 1.16F + 0.05F * static_cast<float>(k), 1.26F);
    }
}

choose::CoverTuft kept(const scene::Tuft& tuft) {
    const glm::vec3 shown = encode(tuft.sent);
    return {tuft.root_m,
            tuft.radius_m * glm::vec2{std::cos(tuft.yaw_rad), std::sin(tuft.yaw_rad)},
            tuft.height_m,
            {unsigned_byte(shown.r), unsigned_byte(shown.g), unsigned_byte(shown.b), unsigned_byte(encode(tuft.lit))}};
}

}  // namespace

void add_cover(gl::Slices& slices, choose::CoverOfScene& cover, const std::shared_ptr<const scene::Scene>& source) {
    slices.prepare([&cover, source] {
        cover.cells = source->sward.cells;
        cover.blossom = scene::seen_by_night(source->sward.blossom, scene::colour_seen(source->sky->darkness));
        cover.reach_m = source->sward.reach_m;
        cover.tufts.reserve(source->sward.tufts.size());
        for (const scene::Tuft& tuft : source->sward.tufts) cover.tufts.push_back(kept(tuft));
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
               sizeof(choose::CoverInstance),
               gl::Advance::PerInstance,
               {{8, 3, GL_FLOAT, gl::Numbers::AsTheyAre, offsetof(choose::CoverInstance, root_m)},
                {9, 4, GL_HALF_FLOAT, gl::Numbers::AsTheyAre, offsetof(choose::CoverInstance, turn_size)},
                {10, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(choose::CoverInstance, ground_lit)},
                {11, 4, GL_UNSIGNED_BYTE, gl::Numbers::Normalised, offsetof(choose::CoverInstance, veil_gust)}}}} {
    CoverMesh mesh;
    std::size_t kind = 0;
    for (const auto make : {add_grass, add_cushion, add_flowers, add_stones}) {  // as scene::CoverKind names them
        first_indices_[kind++] = mesh.indices.size();
        make(mesh);
    }
    vertices_ = gl::Buffer{GL_ARRAY_BUFFER, mesh.vertices.size() * sizeof(CoverVertex)};
    vertices_.write<CoverVertex>(0, mesh.vertices);
    indices_ = gl::Buffer{GL_ELEMENT_ARRAY_BUFFER, mesh.indices.size() * sizeof(std::uint16_t)};
    indices_.write<std::uint16_t>(0, mesh.indices);
}

gl::Work CoverPass::draw(const choose::CoverOfScene& cover, const choose::CoverSeen& seen,
                         const gl::StreamBuffer& instances) const {
    if (seen.batches.empty()) return {};
    program_.use();
    const glm::vec3 blossom = encode(cover.blossom);
    glUniform4f(0, blossom.r, blossom.g, blossom.b, kGust);
    layout_.bind();
    layout_.feed(0, vertices_.name());
    layout_.feed_indices(indices_.name());
    glDisable(GL_CULL_FACE);
    gl::Work work;
    for (const choose::CoverSeen::Batch& batch : seen.batches) {
        layout_.feed(1, instances.name(), batch.first * sizeof(choose::CoverInstance));
        const choose::CoverParts& parts = parts_of(batch.kind);
        const std::size_t triangles = batch.parts * static_cast<std::size_t>(parts.triangles);
        gl::draw_triangles(GL_UNSIGNED_SHORT, first_indices_[static_cast<std::size_t>(batch.kind)], 3 * triangles,
                           batch.count);
        work += {1, batch.count * triangles, batch.count * batch.parts * static_cast<std::size_t>(parts.vertices)};
    }
    glEnable(GL_CULL_FACE);
    return work;
}

}  // namespace quadrat::render::passes
