// SPDX-License-Identifier: Apache-2.0
// Shade by the grid of Palubicki et al. (2009), for trees that did not grow in it. Wind after de Reffye et al., "Plant
// models faithful to botanical structure and development" (SIGGRAPH 1988): limbs die on one side.
#include "synthesis/trees/hardship.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "synthesis/trees/prune.hpp"
#include "synthesis/voxels/shadow_grid.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kLivesBy = 0.6F;  // of its leafy ends, which a tree never sheds
constexpr int kSteps = 12;        // toward it; a tree that is still too shaded sheds nothing

// The light at each site of a tree of height 1.
std::vector<float> lights_of(const TreeSkeleton& skeleton) {
    constexpr float kHeight = 40;   // internodes
    constexpr float kCrown = 2500;  // sites, as which all of them count
    const float each = kCrown / static_cast<float>(std::max<std::size_t>(skeleton.sites.size(), 1));
    voxels::ShadowGrid::Shade shade;
    shade.a = 0.2F * std::min(each, 3.0F);
    shade.far = 0.01F * each;
    voxels::ShadowGrid grid(shade, {-40, 0, -40}, {80, 56, 80});
    std::vector<voxels::ShadowGrid::Change> leaves;
    for (const Site& site : skeleton.sites) leaves.push_back({kHeight * site.at_m, true});
    grid.apply(leaves);
    std::vector<float> lights;
    for (const Site& site : skeleton.sites) lights.push_back(grid.light_at(kHeight * (site.at_m + 0.02F * site.along)));
    return lights;
}

}  // namespace

void set_leaves_by_light(TreeSkeleton& skeleton, float by) {
    if (std::abs(by) < 0.01F) return;
    const std::vector<float> lights = lights_of(skeleton);
    for (std::size_t i = 0; i < lights.size(); ++i)
        skeleton.sites[i].weight *= by < 0 ? 1 + by * (1 - lights[i]) : 1 + 2 * by * (1 - lights[i]);
}

void shed_shaded(TreeSkeleton& skeleton, float least_share) {
    if (least_share <= 0 || skeleton.sites.empty()) return;
    const std::vector<float> lights = lights_of(skeleton);
    std::vector<float> light(skeleton.limbs.size(), 0);
    std::vector<float> ends(skeleton.limbs.size(), 0);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        light[skeleton.sites[k].limb] += lights[k];
        ends[skeleton.sites[k].limb] += 1;
    }
    for (std::size_t i = skeleton.limbs.size(); i-- > 0;) {
        const int parent = skeleton.limbs[i].parent;
        if (parent < 0) continue;
        light[parent] += light[i];
        ends[parent] += ends[i];
    }
    float all = 0;
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i)
        if (skeleton.limbs[i].parent < 0) all += light[i];
    float least = least_share * all / static_cast<float>(skeleton.sites.size());
    // A tree that sheds its crown is a pole: it keeps what it lives by.
    std::vector<float> own(skeleton.limbs.size(), 0);
    for (const Site& site : skeleton.sites) own[site.limb] += 1;
    const auto share_left = [&] {
        std::vector<std::uint8_t> stays(skeleton.limbs.size(), 1);
        float left = 0;
        for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
            const int parent = skeleton.limbs[i].parent;
            if (parent >= 0) stays[i] = stays[parent] != 0 && (ends[i] == 0 || light[i] >= least * ends[i]) ? 1 : 0;
            if (stays[i] != 0) left += own[i];
        }
        return left / static_cast<float>(skeleton.sites.size());
    };
    for (int step = 0; share_left() < kLivesBy; ++step) {
        if (step == kSteps) return;
        least *= 0.85F;
    }
    prune(skeleton, [&](const Limb&, std::size_t i) { return ends[i] == 0 || light[i] >= least * ends[i]; });
}

void face_wind(TreeSkeleton& skeleton, const glm::vec3& wind, base::Seed seed) {
    const float strength = std::min(glm::length(wind), 1.0F);
    if (strength < 0.02F || skeleton.limbs.empty()) return;
    const glm::vec3 upwind = -wind / glm::length(wind);
    prune(skeleton, [&](const Limb& limb, std::size_t i) {
        if (limb.order != 1) return true;
        const glm::vec3 reach = limb.nodes.back().at_m - limb.nodes.front().at_m;
        const float against = glm::dot(reach, upwind) / std::max(glm::length(reach), 1.0e-6F);
        return base::unit_of(base::hash_of(seed, static_cast<std::int64_t>(i), 31)) >
               0.9F * strength * std::max(against, 0.0F);
    });
    const glm::vec3 foot = skeleton.limbs.front().nodes.front().at_m;
    const float high = std::max(skeleton.high_m.y - foot.y, 1.0e-6F);
    const auto blown = [&](glm::vec3& at) {
        const glm::vec3 from_foot = at - foot;
        const float up = std::clamp(from_foot.y / (0.25F * high), 0.0F, 1.0F);
        const float against = glm::dot(from_foot, upwind);
        at += strength * up * (against > 0 ? -0.62F : 0.3F) * against * upwind;
    };
    for (Limb& limb : skeleton.limbs)
        for (Limb::Node& node : limb.nodes) blown(node.at_m);
    for (Site& site : skeleton.sites) blown(site.at_m);
    measure(skeleton);
}

}  // namespace quadrat::synthesis::trees
