// SPDX-License-Identifier: Apache-2.0
// After Hart, Baker & Michaelraj, "Structural simulation of tree growth and response" (The Visual Computer 2003):
// weights and their centres go down the tree once. Thickness is the pipe model's; the stress that is left bends the
// limb.
#include "synthesis/trees/burden.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

constexpr float kLeaves = 0.25F;  // of all wood's weight

struct Held {
    float weight = 0;
    glm::vec3 moment{0};  // weight times place
    void add(float w, const glm::vec3& at) {
        weight += w;
        moment += w * at;
    }
    void add(const Held& other) {
        weight += other.weight;
        moment += other.moment;
    }
};

float volume(const Limb::Node& a, const Limb::Node& b) {
    const float r = 0.5F * (a.radius_m + b.radius_m);
    return 3.1415927F * r * r * glm::length(b.at_m - a.at_m);
}

}  // namespace

std::vector<std::vector<Burden>> burdens_of(const TreeSkeleton& skeleton) {
    std::vector<std::vector<Held>> held;
    held.reserve(skeleton.limbs.size());
    float wood = 0;
    for (const Limb& limb : skeleton.limbs) {
        held.emplace_back(limb.nodes.size());
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) wood += volume(limb.nodes[i - 1], limb.nodes[i]);
    }
    const float leaf = kLeaves * wood / static_cast<float>(std::max<std::size_t>(skeleton.sites.size(), 1));
    for (const Site& site : skeleton.sites) held[site.limb][site.node].add(leaf, site.at_m);
    for (std::size_t l = skeleton.limbs.size(); l-- > 0;) {
        const Limb& limb = skeleton.limbs[l];
        for (std::size_t i = limb.nodes.size() - 1; i-- > 0;) {
            held[l][i].add(held[l][i + 1]);
            held[l][i].add(volume(limb.nodes[i], limb.nodes[i + 1]),
                           0.5F * (limb.nodes[i].at_m + limb.nodes[i + 1].at_m));
        }
        if (limb.parent >= 0) held[limb.parent][limb.parent_node].add(held[l][0]);
    }
    std::vector<std::vector<Burden>> burdens(held.size());
    for (std::size_t l = 0; l < held.size(); ++l) {
        for (std::size_t i = 0; i < held[l].size(); ++i) {
            const Held& h = held[l][i];
            const glm::vec3 off = h.weight > 0 ? h.moment / h.weight - skeleton.limbs[l].nodes[i].at_m : glm::vec3{0};
            burdens[l].push_back({h.weight, std::hypot(off.x, off.z)});
        }
    }
    return burdens;
}

std::vector<std::vector<float>> stresses_of(const TreeSkeleton& skeleton) {
    const auto burdens = burdens_of(skeleton);
    std::vector<std::vector<float>> stresses(burdens.size());
    double sum = 0;
    int count = 0;
    for (std::size_t l = 0; l < burdens.size(); ++l) {
        for (std::size_t i = 0; i < burdens[l].size(); ++i) {
            const float r = std::max(skeleton.limbs[l].nodes[i].radius_m, 1.0e-4F);
            stresses[l].push_back(burdens[l][i].weight * burdens[l][i].lever_m / (r * r * r));
        }
        if (skeleton.limbs[l].order != 1) continue;
        sum += stresses[l].front();
        ++count;
    }
    const float mean = count > 0 ? static_cast<float>(sum / count) : 0;
    for (auto& row : stresses)
        for (float& stress : row) stress = mean > 0 ? stress / mean : 1;
    return stresses;
}

}  // namespace quadrat::synthesis::trees
