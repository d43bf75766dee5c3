// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>

#include "synthesis/trees/burden.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kLeastLength_m = 1.0e-4F;

void reach(TreeSkeleton& skeleton, const glm::vec3& at, float path_m) {
    skeleton.low_m = glm::min(skeleton.low_m, at);
    skeleton.high_m = glm::max(skeleton.high_m, at);
    skeleton.longest_path_m = std::max(skeleton.longest_path_m, path_m);
}

void set_paths_and_sways(TreeSkeleton& skeleton) {
    float most = 0;
    for (Limb& limb : skeleton.limbs) {
        if (limb.parent >= 0) {
            const Limb::Node& bearer = skeleton.limbs[limb.parent].nodes[limb.parent_node];
            limb.nodes.front().path_m = bearer.path_m;
            limb.nodes.front().sway = bearer.sway;
        }
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) {
            const Limb::Node& before = limb.nodes[i - 1];
            const float length_m = glm::length(limb.nodes[i].at_m - before.at_m);
            limb.nodes[i].path_m = before.path_m + length_m;
            limb.nodes[i].sway = before.sway + length_m / std::sqrt(std::max(before.radius_m, 1.0e-3F));
            most = std::max(most, limb.nodes[i].sway);
        }
    }
    const float scale = most > 0 ? 1 / most : 0;
    for (Limb& limb : skeleton.limbs)
        for (Limb::Node& node : limb.nodes) node.sway = std::min(node.sway * scale, 1.0F);
}

// The shortest turn from one direction to another, by this share of it, and by no more than most_rad.
glm::quat turn_toward(const glm::vec3& from, const glm::vec3& to, float share, float most_rad) {
    const glm::vec3 axis = glm::cross(from, to);
    const float sine = glm::length(axis);
    if (sine < 1.0e-5F) return {1, 0, 0, 0};
    const float angle = std::atan2(sine, glm::dot(from, to));
    return glm::angleAxis(std::min(share * angle, most_rad), axis / sine);
}

}  // namespace

void measure(TreeSkeleton& skeleton) {
    skeleton.longest_path_m = 0;
    skeleton.low_m = glm::vec3{1.0e6F};
    skeleton.high_m = glm::vec3{-1.0e6F};
    set_paths_and_sways(skeleton);
    for (const Limb& limb : skeleton.limbs)
        for (const Limb::Node& node : limb.nodes) reach(skeleton, node.at_m, node.path_m);
    for (Site& site : skeleton.sites) {
        const Limb::Node& node = skeleton.limbs[site.limb].nodes[site.node];
        site.path_m = node.path_m + glm::length(site.at_m - node.at_m);
        reach(skeleton, site.at_m, site.path_m);
    }
    if (skeleton.limbs.empty()) skeleton.low_m = skeleton.high_m = glm::vec3{0};
}

void append(TreeSkeleton& to, TreeSkeleton from) {
    const auto first = static_cast<int>(to.limbs.size());
    for (Limb& limb : from.limbs) {
        if (limb.parent >= 0) limb.parent += first;
        to.limbs.push_back(std::move(limb));
    }
    for (Site& site : from.sites) {
        site.limb += first;
        to.sites.push_back(site);
    }
}

void stretch(TreeSkeleton& skeleton, const glm::vec3& factors, float radius_factor) {
    for (Limb& limb : skeleton.limbs) {
        for (Limb::Node& node : limb.nodes) {
            node.at_m *= factors;
            node.radius_m *= radius_factor;
        }
    }
    for (Site& site : skeleton.sites) {
        site.at_m *= factors;
        site.along = glm::normalize(site.along * factors);
        const glm::vec3 out = site.out - glm::dot(site.out, site.along) * site.along;
        if (glm::length(out) > 1.0e-4F) site.out = glm::normalize(out);
    }
}

void set_pipe_radii(TreeSkeleton& skeleton, const PipeModel& model) {
    // Every internode adds a little of its own, so that bare limbs taper too.
    constexpr float kOwn = 0.12F;
    std::vector<std::vector<float>> pipes;
    pipes.reserve(skeleton.limbs.size());
    for (const Limb& limb : skeleton.limbs) pipes.emplace_back(limb.nodes.size(), 0.0F);
    for (std::size_t l = skeleton.limbs.size(); l-- > 0;) {
        const Limb& limb = skeleton.limbs[l];
        pipes[l].back() += 1;
        for (std::size_t i = limb.nodes.size() - 1; i-- > 0;) pipes[l][i] += pipes[l][i + 1] + kOwn;
        if (limb.parent >= 0) pipes[limb.parent][limb.parent_node] += pipes[l][0];
    }
    float most = 1;
    for (std::size_t l = 0; l < skeleton.limbs.size(); ++l)
        if (skeleton.limbs[l].parent < 0) most = std::max(most, pipes[l].front());
    for (std::size_t l = 0; l < skeleton.limbs.size(); ++l) {
        Limb& limb = skeleton.limbs[l];
        for (std::size_t i = 0; i < limb.nodes.size(); ++i)
            limb.nodes[i].radius_m = std::max(
                model.trunk_radius_m * std::pow(pipes[l][i] / most, 1.0F / model.exponent), model.least_radius_m);
        // Where it begins it is as thick as it goes on: what it bears there belongs to it.
        if (limb.parent >= 0 && limb.nodes.size() > 1)
            limb.nodes[0].radius_m =
                std::min(limb.nodes[0].radius_m, 0.92F * skeleton.limbs[limb.parent].nodes[limb.parent_node].radius_m);
    }
}

void bend(TreeSkeleton& skeleton, const Forces& forces) {
    const auto stresses = stresses_of(skeleton);
    const TreeSkeleton before = skeleton;
    std::vector<std::vector<glm::quat>> turns;
    turns.reserve(skeleton.limbs.size());
    const float wind = glm::length(forces.wind);
    const float light = glm::length(forces.light);
    for (std::size_t l = 0; l < skeleton.limbs.size(); ++l) {
        Limb& limb = skeleton.limbs[l];
        const Limb& old = before.limbs[l];
        auto& turn = turns.emplace_back(limb.nodes.size(), glm::quat{1, 0, 0, 0});
        if (limb.parent >= 0) {
            turn[0] = turns[limb.parent][limb.parent_node];
            limb.nodes[0].at_m = skeleton.limbs[limb.parent].nodes[limb.parent_node].at_m;
        }
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) {
            const glm::vec3 step = old.nodes[i].at_m - old.nodes[i - 1].at_m;
            const float length_m = glm::length(step);
            turn[i] = turn[i - 1];
            if (length_m < kLeastLength_m) {
                limb.nodes[i].at_m = limb.nodes[i - 1].at_m + turn[i] * step;
                continue;
            }
            glm::vec3 heading = turn[i] * (step / length_m);
            const float radius_m = std::max(old.nodes[i - 1].radius_m, 0.004F);
            const float slender = std::min(length_m / (32.0F * radius_m), 1.0F);
            const auto apply = [&](const glm::vec3& toward, float share, float most_rad) {
                const glm::quat q = turn_toward(heading, toward, share, most_rad);
                turn[i] = glm::normalize(q * turn[i]);
                heading = q * heading;
            };
            if (forces.sag > 0 && (limb.order > 0 || limb.parent >= 0)) {
                // Wood has grown thick enough to hold most of its load; twigs hang with what they bear.
                const float burden = std::min(0.7F * stresses[l][i - 1], 1.5F);
                apply({0, -1, 0}, forces.sag * slender * (0.05F + 0.07F * burden), 0.25F);
                // Tension wood on the upper side of what is young, compression wood below it, turn the end up again.
                const float young = static_cast<float>(i) / static_cast<float>(limb.nodes.size() - 1);
                apply({0, 1, 0}, forces.straightening * forces.sag * slender * 0.5F * young * young, 0.25F);
            }
            if (wind > 0) apply(forces.wind / wind, wind * 0.22F * slender, 0.2F);
            if (light > 0 && limb.order > 0) apply(forces.light / light, light * 0.16F * slender, 0.2F);
            limb.nodes[i].at_m = limb.nodes[i - 1].at_m + length_m * heading;
        }
    }
    for (Site& site : skeleton.sites) {
        const glm::quat& turn = turns[site.limb][site.node];
        site.at_m = skeleton.limbs[site.limb].nodes[site.node].at_m +
                    turn * (site.at_m - before.limbs[site.limb].nodes[site.node].at_m);
        site.along = turn * site.along;
        site.out = turn * site.out;
    }
    measure(skeleton);
}

std::vector<std::uint32_t> strongest_limbs(const TreeSkeleton& skeleton, std::size_t most_nodes) {
    std::vector<std::uint32_t> order(skeleton.limbs.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto strength = [&](std::uint32_t i) {
        const Limb& limb = skeleton.limbs[i];
        return limb.parent < 0 ? 1.0e6F : limb.nodes.front().radius_m;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return strength(a) > strength(b); });
    std::vector<bool> is_kept(skeleton.limbs.size(), false);
    std::vector<std::uint32_t> kept;
    std::size_t nodes = 0;
    for (const std::uint32_t i : order) {
        const Limb& limb = skeleton.limbs[i];
        if (!kept.empty() && nodes + limb.nodes.size() > most_nodes) break;
        if (limb.parent >= 0 && !is_kept[limb.parent]) continue;
        is_kept[i] = true;
        nodes += limb.nodes.size();
        kept.push_back(i);
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

}  // namespace quadrat::synthesis::trees
