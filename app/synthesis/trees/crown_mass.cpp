// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/crown_mass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <numeric>
#include <span>

#include "base/seed.hpp"
#include "mesh/isosurface.hpp"
#include "mesh/pieces.hpp"
#include "mesh/progressive.hpp"
#include "mesh/sparse_field.hpp"
#include "synthesis/trees/crown_lumps.hpp"
#include "synthesis/trees/crown_outline.hpp"
#include "synthesis/trees/crown_reach.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr int kAcross = 16;                // samples over a crown's breadth
constexpr int kUp = 30;                    // and over its height, if fewer fit into it
constexpr int kRim = 3;                    // and beside it, for the blur
constexpr std::size_t kFewestInside = 18;  // samples; less is no mass
constexpr std::size_t kFinest = 60;        // vertices
constexpr std::size_t kCoarsest = 18;
constexpr std::size_t kFewestTriangles = 24;
constexpr float kSeen = 1.25F;       // of the light of all leaves about a place, that of those one sees
constexpr float kMostLarger = 2.2F;  // a clump that stands for those left out

// What the leaves about a sample are, weighted by their area.
struct Sample {
    float area_m2 = 0;
    glm::vec3 colour{0};
    float shade = 0, age = 0, sway = 0;

    Sample& operator+=(const Sample& o) {
        area_m2 += o.area_m2;
        colour += o.colour;
        shade += o.shade;
        age += o.age;
        sway += o.sway;
        return *this;
    }
    Sample operator*(float f) const { return {area_m2 * f, colour * f, shade * f, age * f, sway * f}; }
};

class Density {
  public:
    Density(const scene::Leaves& leaves, float dense) : dense_(dense) {
        glm::vec3 low = leaves.vertices.front().site_m;
        glm::vec3 high = low;
        for (const scene::Leaves::Vertex& v : leaves.vertices) {
            low = glm::min(low, v.site_m + v.corner_m);
            high = glm::max(high, v.site_m + v.corner_m);
            reach_m_ = std::max(reach_m_, glm::length(v.site_m + v.corner_m));
        }
        low_m_ = low;
        high_m_ = high;
        const glm::vec3 extent = high - low;
        // The spire of a slender crown has cells of its own.
        cell_m_ = std::max({std::max(extent.x, extent.z) / kAcross, extent.y / kUp, 0.001F});
        // Its density is as of the cells of a round one.
        dense_ *= cell_m_ * kAcross / std::max({extent.x, extent.y, extent.z, 0.01F});
        size_ = glm::ivec3{glm::ceil(extent / cell_m_)} + 2 * kRim + 1;
        origin_m_ = low - static_cast<float>(kRim) * cell_m_;
        samples_.resize(static_cast<std::size_t>(size_.x * size_.y * size_.z));
        const std::size_t per_blade = leaves.indices_per_blade();
        for (std::size_t blade = 0; blade < leaves.blades; ++blade)
            add(leaves, std::span(leaves.indices).subspan(blade * per_blade, per_blade));
        for (int pass = 0; pass < 2 * 3; ++pass) blur(pass % 3);  // twice: a crown is round from afar
        spread_to_most();
    }

    const glm::ivec3& size() const { return size_; }
    float cell_m() const { return cell_m_; }
    CrownLumps lumps() const { return {low_m_, high_m_}; }
    float reach_m() const { return reach_m_; }  // of the leaves, from the root
    float area_m2(bool is_inside_only) const {
        float sum = 0;
        for (const Sample& sample : samples_)
            if (!is_inside_only || sample.area_m2 > dense_ * cell_m_ * cell_m_) sum += sample.area_m2;
        return sum;
    }
    const Sample& at(glm::ivec3 i) const { return samples_[index(i)]; }
    float over(glm::ivec3 i) const { return at(i).area_m2 / (cell_m_ * cell_m_) / dense_ - 1; }
    glm::vec3 place_m(glm::vec3 in_samples) const { return origin_m_ + in_samples * cell_m_; }
    // Of the eight about a place, by how near they are.
    Sample between(glm::vec3 at_m) const {
        const glm::vec3 in = glm::clamp((at_m - origin_m_) / cell_m_, glm::vec3{0}, glm::vec3{size_ - 1} - 1e-3F);
        const glm::ivec3 low{in};
        const glm::vec3 f = in - glm::vec3{low};
        Sample sum;
        for (int k = 0; k < 8; ++k) {
            const glm::ivec3 step{k & 1, (k >> 1) & 1, k >> 2};
            const glm::vec3 share = glm::mix(1.0F - f, f, glm::vec3{step});
            sum += at(low + step) * (share.x * share.y * share.z);
        }
        return sum;
    }
    // Of unit length.
    glm::vec3 outward(glm::vec3 at_m) const {
        glm::vec3 fall{0};
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 step{0};
            step[axis] = cell_m_;
            fall[axis] = between(at_m - step).area_m2 - between(at_m + step).area_m2;
        }
        const float length = glm::length(fall);
        return length > 1e-9F ? fall / length : glm::vec3{0, 1, 0};
    }

  private:
    std::size_t index(glm::ivec3 i) const { return static_cast<std::size_t>((i.z * size_.y + i.y) * size_.x + i.x); }

    void add(const scene::Leaves& leaves, std::span<const std::uint32_t> blade) {
        Sample leaf;
        glm::vec3 middle{0};
        for (std::size_t i = 0; i + 2 < blade.size(); i += 3) {
            std::array<glm::vec3, 3> corner{};
            for (std::size_t k = 0; k < 3; ++k)
                corner[k] = leaves.vertices[blade[i + k]].site_m + leaves.vertices[blade[i + k]].corner_m;
            const float area = 0.5F * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
            leaf.area_m2 += area;
            for (std::size_t k = 0; k < 3; ++k) leaf.colour += area / 3 * leaves.vertices[blade[i + k]].colour;
            middle += area / 3 * (corner[0] + corner[1] + corner[2]);
        }
        if (leaf.area_m2 <= 0) return;
        middle /= leaf.area_m2;
        const scene::Leaves::Vertex& v = leaves.vertices[blade.front()];
        leaf.shade = v.shade * leaf.area_m2;
        leaf.age = v.age * leaf.area_m2;
        leaf.sway = v.sway * leaf.area_m2;
        samples_[index(glm::ivec3{glm::round((middle - origin_m_) / cell_m_)})] += leaf;
    }

    // By a quarter to each neighbour.
    void blur(int axis) {
        glm::ivec3 step{0};
        step[axis] = 1;
        std::vector<Sample> blurred(samples_.size());
        glm::ivec3 i;
        for (i.z = 1; i.z + 1 < size_.z; ++i.z) {
            for (i.y = 1; i.y + 1 < size_.y; ++i.y) {
                for (i.x = 1; i.x + 1 < size_.x; ++i.x) {
                    Sample sum = at(i) * 0.5F;
                    sum += at(i - step) * 0.25F;
                    sum += at(i + step) * 0.25F;
                    blurred[index(i)] = sum;
                }
            }
        }
        samples_ = std::move(blurred);
    }

    // A crown's thin parts are of its mass too, or their leaves would be left to float about it: so much of the leaves
    // is inside, unless that would make a mass of single leaves. A plant that is dense nowhere has no crown.
    void spread_to_most() {
        constexpr float kMost = 0.84F;
        constexpr float kThinnest = 0.2F;  // of what is dense
        constexpr float kLeast = 0.03F;    // of the leaves where they are dense
        std::vector<float> areas;
        float all = 0;
        for (const Sample& sample : samples_) {
            if (sample.area_m2 <= 0) continue;
            areas.push_back(sample.area_m2);
            all += sample.area_m2;
        }
        if (area_m2(true) < kLeast * all) return;
        std::ranges::sort(areas, std::greater{});
        float inside = 0;
        for (const float area : areas) {
            inside += area;
            if (inside < kMost * all) continue;
            dense_ = std::clamp(area / (cell_m_ * cell_m_), kThinnest * dense_, dense_);
            return;
        }
    }

    glm::ivec3 size_{0};
    float dense_;
    glm::vec3 low_m_{0}, high_m_{0};  // the box about the leaves
    glm::vec3 origin_m_{0};
    float cell_m_ = 1;
    float reach_m_ = 0;
    std::vector<Sample> samples_;
};

// Nothing where too little is inside.
mesh::SparseField field_of(const Density& density, std::size_t& inside) {
    constexpr int kSide = mesh::SparseField::kSide;
    const glm::ivec3 blocks = (density.size() + kSide - 1) / kSide;
    mesh::SparseField field(blocks);
    glm::ivec3 place;
    for (place.z = 0; place.z < blocks.z; ++place.z) {
        for (place.y = 0; place.y < blocks.y; ++place.y) {
            for (place.x = 0; place.x < blocks.x; ++place.x) {
                mesh::SparseField::Block& block = field.block(static_cast<std::size_t>(field.make(place)));
                for (int n = 0; n < mesh::SparseField::kSamples; ++n) {
                    const glm::ivec3 i = place * kSide + glm::ivec3{n % kSide, n / kSide % kSide, n / (kSide * kSide)};
                    const bool is_known =
                        glm::all(glm::greaterThanEqual(i, glm::ivec3{0})) && glm::all(glm::lessThan(i, density.size()));
                    block[static_cast<std::size_t>(n)] = is_known ? std::clamp(density.over(i), -1.0F, 1.0F) : -1.0F;
                    inside += block[static_cast<std::size_t>(n)] > 0;
                }
            }
        }
    }
    return field;
}

// Leaves are not all as light: a smooth mass reads as clay. By the place, so that levels agree.
float mottle(const glm::vec3& at_m) {
    constexpr float kLighter = 0.14F;
    const auto cell = [](float m) { return std::lround(m * 1024); };
    const float chance =
        base::unit_of(base::hash_of(base::Seed{0x6D}, cell(at_m.x) * 8191 + cell(at_m.y), cell(at_m.z)));
    return 1 + kLighter * (2 * chance - 1);
}

scene::CrownMass coloured(const mesh::Mesh& mesh, const Density& density, float share) {
    scene::CrownMass mass;
    mass.share = share;
    mass.mesh = mesh;
    mass.mesh.normals.clear();
    const CrownLumps lumps = density.lumps();
    for (const glm::vec3& at_m : mesh.positions_m) {
        const glm::vec3 out = density.outward(at_m);
        // The leaves that are seen of a crown are those outside.
        Sample near = density.between(at_m + out * density.cell_m());
        if (near.area_m2 <= 0) near = density.between(at_m);
        const float per_m2 = 1 / std::max(near.area_m2, 1e-9F);
        mass.mesh.normals.push_back(lumps.normal(at_m, out));
        mass.colours.push_back(near.colour * per_m2 * mottle(at_m) * lumps.light(at_m));
        mass.shades.push_back(std::clamp(kSeen * near.shade * per_m2, 0.0F, 1.0F));
        mass.ages.push_back(std::clamp(near.age * per_m2, 0.0F, 1.0F));
        mass.sways.push_back(std::clamp(near.sway * per_m2, 0.0F, 1.0F));
    }
    return mass;
}

// Times six.
float volume_of(const mesh::Mesh& mesh) {
    float sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        sum += glm::dot(mesh.positions_m[mesh.indices[i]] - mesh.positions_m.front(),
                        glm::cross(mesh.positions_m[mesh.indices[i + 1]] - mesh.positions_m.front(),
                                   mesh.positions_m[mesh.indices[i + 2]] - mesh.positions_m.front()));
    return sum;
}

using Clump = std::vector<std::uint32_t>;  // the first indices of its triangles

glm::vec3 corner_of(const mesh::Mesh& mesh, std::uint32_t index) { return mesh.positions_m[mesh.indices[index]]; }

float area_m2(const mesh::Mesh& mesh, const Clump& clump) {
    float sum = 0;
    for (const std::uint32_t i : clump)
        sum += 0.5F * glm::length(glm::cross(corner_of(mesh, i + 1) - corner_of(mesh, i),
                                             corner_of(mesh, i + 2) - corner_of(mesh, i)));
    return sum;
}

glm::vec3 middle_m(const mesh::Mesh& mesh, const Clump& clump) {
    glm::vec3 sum{0};
    for (const std::uint32_t first : clump)
        for (std::uint32_t k = 0; k < 3; ++k) sum += corner_of(mesh, first + k);
    return sum / static_cast<float>(3 * clump.size());
}

// What is left of a crown when all but some of its clumps are left out.
struct Fewer {
    mesh::Mesh mesh;
    std::vector<std::uint32_t> sources;  // the crown's vertex that each of these is
    std::vector<glm::vec3> at_m;         // where each of the crown's is now; of a clump that is left out, in its middle
};

// The first so many of these clumps are left, each so much larger, but no further from the root than the crown was.
Fewer enlarged(const mesh::Mesh& crown, std::span<const Clump> clumps, std::size_t kept, float larger) {
    const float most_m = reach_m(crown);
    Fewer fewer;
    fewer.at_m = crown.positions_m;
    for (std::size_t c = 0; c < clumps.size(); ++c) {
        const glm::vec3 about_m = middle_m(crown, clumps[c]);
        std::map<std::uint32_t, std::uint32_t> now;
        for (const std::uint32_t first : clumps[c]) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t was = crown.indices[first + k];
                const auto [at, is_new] = now.try_emplace(was, static_cast<std::uint32_t>(fewer.sources.size()));
                if (is_new) {
                    const glm::vec3 larger_m = glm::mix(about_m, crown.positions_m[was], larger);
                    fewer.at_m[was] = c < kept ? within(larger_m, most_m) : about_m;
                }
                if (c >= kept) continue;
                fewer.mesh.indices.push_back(at->second);
                if (!is_new) continue;
                fewer.sources.push_back(was);
                fewer.mesh.positions_m.push_back(fewer.at_m[was]);
            }
        }
    }
    return fewer;
}

// With so many triangles at most but one clump at least. They are larger for it, so that as much is covered as may be.
Fewer first_clumps(const mesh::Mesh& crown, std::span<const Clump> clumps, std::size_t most_triangles) {
    const auto area = [&](const Clump& clump) { return area_m2(crown, clump); };
    float all_m2 = 0;
    for (const Clump& clump : clumps) all_m2 += area(clump);
    float kept_m2 = 0;
    std::size_t kept = 0;
    for (std::size_t triangles = 0; kept < clumps.size(); ++kept) {
        triangles += clumps[kept].size();
        if (kept > 0 && triangles > most_triangles) break;
        kept_m2 += area(clumps[kept]);
    }
    const float larger = std::min(std::sqrt(all_m2 / std::max(kept_m2, 1e-9F)), kMostLarger);
    return enlarged(crown, clumps, kept, larger);
}

// These of its vertices, with all that they are but their place.
scene::CrownMass fewer_of(const scene::CrownMass& from, const Fewer& fewer) {
    scene::CrownMass mass;
    mass.share = from.share;
    mass.mesh = fewer.mesh;
    for (const std::uint32_t source : fewer.sources) {
        mass.mesh.normals.push_back(from.mesh.normals[source]);
        mass.colours.push_back(from.colours[source]);
        mass.shades.push_back(from.shades[source]);
        mass.ages.push_back(from.ages[source]);
        mass.sways.push_back(from.sways[source]);
    }
    return mass;
}

// Where clumps cannot be any simpler, there are fewer of them, the largest.
void add_fewer_clumps(std::vector<scene::CrownMass>& masses) {
    const scene::CrownMass whole = masses.back();
    const mesh::Mesh& simplest = whole.mesh;
    auto clumps = mesh::pieces_of(simplest);
    std::ranges::stable_sort(clumps, std::greater{}, [&](const Clump& clump) { return area_m2(simplest, clump); });
    std::vector<std::uint32_t> sources(simplest.positions_m.size());
    std::iota(sources.begin(), sources.end(), 0U);
    for (std::size_t most = simplest.triangle_count() / 2; most >= kFewestTriangles; most /= 2) {
        Fewer fewer = first_clumps(simplest, clumps, most);
        if (fewer.mesh.triangle_count() >= masses.back().mesh.triangle_count()) return;
        for (const std::uint32_t source : sources) masses.back().coarser_m.push_back(fewer.at_m[source]);
        masses.push_back(fewer_of(whole, fewer));
        sources = std::move(fewer.sources);
    }
}

}  // namespace

std::vector<scene::CrownMass> crown_masses(const scene::Leaves& leaves, float dense) {
    if (leaves.blades == 0) return {};
    const Density density(leaves, dense);
    std::size_t inside = 0;
    const mesh::SparseField field = field_of(density, inside);
    if (inside < kFewestInside) return {};
    const mesh::Surface surface = mesh::polygonise(field);
    mesh::Mesh whole;
    const CrownLumps lumps = density.lumps();
    for (const glm::vec3& p : surface.positions) {
        const glm::vec3 at_m = density.place_m(p);
        whole.positions_m.push_back(within(at_m + lumps.outward_m(at_m) * density.outward(at_m), density.reach_m()));
    }
    whole.indices = surface.indices;
    mesh::ProgressiveOptions options;
    options.fewest = kCoarsest;
    std::vector<scene::CrownMass> masses;
    const float share = density.area_m2(true) / std::max(density.area_m2(false), 1e-9F);
    const mesh::Progressive chain = mesh::make_progressive(whole, options);
    // Small clumps may be flat before the last level: such a one is no crown any more.
    constexpr float kLeastVolume = 0.5F;
    const float whole_volume = volume_of(chain.levels.front().mesh);
    const auto is_crown = [&](std::size_t i) { return volume_of(chain.levels[i].mesh) >= kLeastVolume * whole_volume; };
    std::size_t first = 0;
    while (chain.levels[first].mesh.positions_m.size() > kFinest && first + 1 < chain.levels.size() &&
           is_crown(first + 1))
        ++first;
    for (std::size_t i = first; i < chain.levels.size() && is_crown(i); ++i) {
        if (!masses.empty()) masses.back().coarser_m = mesh::morph_targets_m(chain, i - 1);
        masses.push_back(coloured(chain.levels[i].mesh, density, share));
    }
    if (!masses.empty()) add_fewer_clumps(masses);
    add_outline(masses, kRoundOutline);
    return masses;
}

}  // namespace quadrat::synthesis::trees
