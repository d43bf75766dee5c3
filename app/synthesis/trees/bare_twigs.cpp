// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/bare_twigs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/colour.hpp"
#include "synthesis/trees/foliage.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kPerCrown = 190;   // twigs, of a crown of a metre's radius; of larger ones by their mantle
constexpr float kThin = 0.020F;    // half a twig's width, to its length
constexpr float kLengths = 0.17F;  // of a twig, to the crown's radius
constexpr float kShortest_m = 0.18F;

glm::vec3 across(const glm::vec3& along) {
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    return glm::normalize(glm::cross(along, other));
}

glm::vec3 direction(base::RandomStream& random) {
    const glm::vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    return v / std::max(glm::length(v), 0.1F);
}

}  // namespace

scene::Leaves bare_twigs(const TreeSkeleton& skeleton, float crown_radius_m, const glm::vec3& bark,
                         const LeafShape& shape, std::size_t most, base::Seed seed) {
    scene::Leaves twigs;
    std::vector<const Site*> bare;
    for (const Site& site : skeleton.sites)
        if (site.organ == Organ::None) bare.push_back(&site);
    if (bare.empty()) return twigs;
    const float share = static_cast<float>(bare.size()) / static_cast<float>(skeleton.sites.size());
    const float wanted = kPerCrown * share * std::max(crown_radius_m, 0.4F);
    const std::size_t count = std::min(static_cast<std::size_t>(wanted), most);
    const glm::vec3 middle_m = 0.5F * (skeleton.low_m + skeleton.high_m);
    const glm::vec3 half_m = glm::max(0.5F * (skeleton.high_m - skeleton.low_m), glm::vec3{0.2F});
    for (std::size_t i = 0; i < count; ++i) {
        base::RandomStream random{base::Seed{base::hash_of(seed, 0, static_cast<std::int64_t>(i))}};
        // By chance, so that a prefix has twigs of the whole crown.
        const Site& site = *bare[random.below(static_cast<std::uint32_t>(bare.size()))];
        const glm::vec3 outward = (site.at_m - middle_m) / half_m;
        const glm::vec3 out = outward / std::max(glm::length(outward), 0.1F);
        BladeShape twig;
        twig.site_m = site.at_m;
        twig.along = glm::normalize(site.along + 0.5F * site.out + 0.35F * out + 0.45F * direction(random) +
                                    glm::vec3{0, 0.2F, 0});
        twig.face = across(twig.along);
        twig.length_m = std::max(kLengths * crown_radius_m, kShortest_m) * random.between(0.6F, 1.3F);
        twig.half_width_m = kThin * twig.length_m;
        twig.fold_m = 0;
        twig.bow_m = 0.35F * twig.length_m * random.between(-1, 1);
        scene::Leaves::Vertex vertex;
        vertex.normal = glm::normalize(out + 0.5F * twig.face + glm::vec3{0, 0.25F, 0});
        vertex.colour = scene::shifted_colour(bark, random.between(0.95F, 1.15F));
        vertex.shade = 0.85F;
        const float along = std::min(site.path_m / std::max(skeleton.longest_path_m, 1.0e-3F), 1.0F);
        vertex.age = std::min(0.12F + 0.83F * along, 1.0F);
        vertex.sway = std::clamp(skeleton.limbs[site.limb].nodes[site.node].sway, 0.0F, 1.0F);
        add_blade(twigs, shape, twig, vertex);
    }
    return twigs;
}

}  // namespace quadrat::synthesis::trees
