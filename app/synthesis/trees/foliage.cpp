// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/foliage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "scene/colour.hpp"

namespace quadrat::synthesis::trees {
namespace {

glm::vec3 any_direction(base::RandomStream& random) {
    for (;;) {
        const glm::vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const float r = glm::dot(v, v);
        if (r > 0.01F && r < 1) return v / std::sqrt(r);
    }
}

struct Crown {
    glm::vec3 middle_m;
    glm::vec3 half_m;
};

Crown crown_of(const TreeSkeleton& skeleton) {
    glm::vec3 low{1.0e6F};
    glm::vec3 high{-1.0e6F};
    for (const LeafSite& site : skeleton.sites) {
        low = glm::min(low, site.at_m);
        high = glm::max(high, site.at_m);
    }
    return {0.5F * (low + high), glm::max(0.5F * (high - low), glm::vec3{0.2F})};
}

// How much light comes down through the blades: each cell's own and those above it and beside that, fading.
class CrownLight {
  public:
    CrownLight(const Crown& crown, std::span<const glm::vec3> sites) : crown_(crown) {
        const float each = 620.0F / static_cast<float>(std::max<std::size_t>(sites.size(), 1));
        for (const glm::vec3& site : sites) cell(index(site)) += each;
        // From the top down: what stands over a cell is its share of what stood over the nine above.
        for (int y = kCells - 2; y >= 0; --y)
            for (int z = 0; z < kCells; ++z)
                for (int x = 0; x < kCells; ++x) over(x, y, z) = gathered(x, y + 1, z);
    }

    float at(const glm::vec3& point) const {
        const auto i = index(point);
        const float depth = 0.5F * density_[flat(i[0], i[1], i[2])] + above_[flat(i[0], i[1], i[2])];
        return 0.30F + 0.70F * std::exp(-0.30F * depth);
    }

  private:
    static constexpr int kCells = 10;
    static std::size_t flat(int x, int y, int z) { return static_cast<std::size_t>((y * kCells + z) * kCells + x); }

    std::array<int, 3> index(const glm::vec3& p) const {
        std::array<int, 3> i{};
        for (int k = 0; k < 3; ++k) {
            const float unit = 0.5F + 0.5F * (p[k] - crown_.middle_m[k]) / crown_.half_m[k];
            i[k] = std::clamp(static_cast<int>(unit * kCells), 0, kCells - 1);
        }
        return i;
    }
    float& cell(const std::array<int, 3>& i) { return density_[flat(i[0], i[1], i[2])]; }
    float& over(int x, int y, int z) { return above_[flat(x, y, z)]; }

    float gathered(int x, int y, int z) const {
        float sum = 0;
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dx = -1; dx <= 1; ++dx) {
                const int cx = std::clamp(x + dx, 0, kCells - 1);
                const int cz = std::clamp(z + dz, 0, kCells - 1);
                const float weight = dx == 0 && dz == 0 ? 0.36F : 0.08F;
                sum += weight * (density_[flat(cx, y, cz)] + above_[flat(cx, y, cz)]);
            }
        }
        return sum;
    }

    Crown crown_;
    std::array<float, kCells * kCells * kCells> density_{};
    std::array<float, kCells * kCells * kCells> above_{};
};

struct Site {
    glm::vec3 at_m;
    glm::vec3 along;
    float path_m;
};

// Blades spread over the sites in turn, then shuffled, so that a prefix covers the whole crown.
std::vector<Site> shuffled_sites(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed) {
    std::vector<Site> sites;
    sites.reserve(options.blades);
    for (std::size_t i = 0; i < options.blades; ++i) {
        base::RandomStream random{seed.child("site").child(i)};
        const std::size_t count = skeleton.sites.size();
        const LeafSite& at = skeleton.sites[options.blades < count ? i * count / options.blades : i % count];
        sites.push_back({at.at_m + options.scatter_m * random.unit_f() * any_direction(random), at.along, at.path_m});
    }
    base::RandomStream random{seed.child("shuffle")};
    for (std::size_t i = sites.size(); i > 1; --i)
        std::swap(sites[i - 1], sites[random.below(static_cast<std::uint32_t>(i))]);
    return sites;
}

}  // namespace

void add_spike(scene::Leaves& leaves, const BladeShape& b, const scene::Leaves::Vertex& common) {
    const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
    const glm::vec3 across = glm::cross(b.along, b.face);
    for (const glm::vec3& corner :
         {-b.half_width_m * across, b.half_width_m * across, b.length_m * b.along + b.bow_m * b.face}) {
        scene::Leaves::Vertex vertex = common;
        vertex.site_m = b.site_m;
        vertex.corner_m = corner;
        leaves.vertices.push_back(vertex);
    }
    leaves.indices.insert(leaves.indices.end(), {first, first + 1, first + 2});
    ++leaves.blades;
}

void add_blade(scene::Leaves& leaves, const BladeShape& b, const scene::Leaves::Vertex& common) {
    const auto first = static_cast<std::uint32_t>(leaves.vertices.size());
    const glm::vec3 across = glm::cross(b.along, b.face);
    const float middle_m = 0.45F * b.length_m;
    const std::array<glm::vec3, 4> corners{
        glm::vec3{0}, middle_m * b.along + b.half_width_m * across + (b.fold_m + 0.3F * b.bow_m) * b.face,
        b.length_m * b.along + b.bow_m * b.face,
        middle_m * b.along - b.half_width_m * across + (b.fold_m + 0.3F * b.bow_m) * b.face};
    for (const glm::vec3& corner : corners) {
        scene::Leaves::Vertex vertex = common;
        vertex.site_m = b.site_m;
        vertex.corner_m = corner;
        leaves.vertices.push_back(vertex);
    }
    leaves.indices.insert(leaves.indices.end(), {first, first + 2, first + 1, first, first + 3, first + 2});
    ++leaves.blades;
}

scene::Leaves make_foliage(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed) {
    scene::Leaves leaves;
    if (skeleton.sites.empty() || options.blades == 0) return leaves;
    const Crown crown = crown_of(skeleton);
    const std::vector<Site> sites = shuffled_sites(skeleton, options, seed);
    std::vector<glm::vec3> places;
    for (const Site& site : sites) places.push_back(site.at_m);
    const CrownLight light(crown, places);
    leaves.vertices.reserve(4 * sites.size());
    leaves.indices.reserve(6 * sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        base::RandomStream random{seed.child("blade").child(i)};
        const Site& site = sites[i];
        const glm::vec3 outward = (site.at_m - crown.middle_m) / crown.half_m;
        const float out = std::min(glm::length(outward), 1.2F);
        const glm::vec3 out_unit = outward / std::max(glm::length(outward), 1.0e-3F);
        const glm::vec3 hang{0, -1, 0};
        BladeShape blade;
        blade.site_m = site.at_m;
        blade.along = glm::normalize(0.6F * site.along + 0.5F * out_unit + 0.8F * any_direction(random) +
                                     1.6F * options.droop * hang);
        // Blades turn their flat side to the light.
        const glm::vec3 wish = out_unit + glm::vec3{0, 0.7F, 0} + 0.6F * any_direction(random);
        const glm::vec3 face = wish - glm::dot(wish, blade.along) * blade.along;
        blade.face = glm::length(face) > 1.0e-3F ? glm::normalize(face)
                                                 : glm::normalize(glm::cross(blade.along, glm::vec3{0.3F, 0.5F, 0.8F}));
        blade.length_m = options.length_m * random.between(0.75F, 1.2F);
        blade.half_width_m = 0.5F * options.width * blade.length_m;
        blade.fold_m = options.fold * blade.half_width_m;
        blade.bow_m = -0.12F * blade.length_m;
        scene::Leaves::Vertex vertex;
        vertex.normal = glm::normalize(0.35F * blade.face + out_unit + glm::vec3{0, 0.25F, 0});
        vertex.shade = light.at(site.at_m) * (0.72F + 0.28F * std::min(out, 1.0F));
        const float lean = random.unit_f();
        vertex.colour = scene::shifted_colour(scene::mix_colours(options.colour, options.second, lean * lean),
                                              random.between(0.93F, 1.07F));
        const float share = std::min(site.path_m / std::max(skeleton.longest_path_m, 1.0e-3F), 1.0F);
        vertex.age = std::min(0.12F + 0.83F * share, 1.0F);
        vertex.sway = share * std::sqrt(share);
        add_blade(leaves, blade, vertex);
    }
    return leaves;
}

}  // namespace quadrat::synthesis::trees
