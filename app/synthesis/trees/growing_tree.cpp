// SPDX-License-Identifier: Apache-2.0
// Palubicki et al., "Self-organizing tree models for image synthesis" (SIGGRAPH 2009), with shadow propagation and the
// extended Borchert-Honda model: light Q goes down the tree, v = α Q comes up it, shared at each node by
// v_m = v λ Q_m / (λ Q_m + (1 − λ) Q_l). A bud that gets v makes ⌊v⌋ internodes of length v / ⌊v⌋. Ours has any number
// of laterals at a node, λ that changes with age, and buds that give up.
#include "synthesis/trees/growing_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis::trees {
namespace {

constexpr glm::vec3 kUp{0, 1, 0};
constexpr float kLeastHeight = 1.2F;  // over the ground
constexpr int kTenderYears = 3;       // a limb so young does not fall

glm::vec3 across(const glm::vec3& wish, const glm::vec3& along) {
    const glm::vec3 v = wish - glm::dot(wish, along) * along;
    const float length2 = glm::dot(v, v);
    if (length2 > 1.0e-6F) return v / std::sqrt(length2);
    const glm::vec3 other = std::abs(along.y) < 0.9F ? kUp : glm::vec3{1, 0, 0};
    return glm::normalize(glm::cross(along, other));
}

}  // namespace

GrowingTree::GrowingTree(const SelfOrganisation& parameters, const Seedling& seedling, base::Seed seed)
    : p_(parameters), seed_(seed), root_{seedling.at.x, 0, seedling.at.y} {
    Internode root;
    root.end = root_;
    root.heading = glm::normalize(glm::vec3{seedling.lean.x, 1, seedling.lean.y});
    const float turn = 3.1415927F * chance(0, 9);
    root.out = across({std::cos(turn), 0, std::sin(turn)}, root.heading);
    nodes_.push_back(root);
}

float GrowingTree::chance(int index, int what) const {
    return 2 * base::unit_of(base::hash_of(seed_, index, what)) - 1;
}

void GrowingTree::sense(const voxels::ShadowGrid& grid) {
    living_buds_ = 0;
    // Salt, frost and drought come with the wind (de Reffye et al. 1988: buds die by chance and by where they stand).
    const auto alive_in_wind = [this](const glm::vec3& heading) {
        return 1 - std::max(glm::dot(heading, p_.upwind), 0.0F);
    };
    for (Internode& node : nodes_) {
        if (node.is_gone) continue;
        const glm::vec3 at = node.end + 0.5F * node.heading;
        node.light = node.main < 0 ? grid.light_at(at) * alive_in_wind(node.heading) : 0;
        living_buds_ += node.main < 0;
        for (int b = node.first_bud; b < node.first_bud + node.buds; ++b) {
            AxilBud& bud = buds_[b];
            bud.light = bud.is_alive && bud.child < 0
                            ? grid.light_at(node.end + 0.5F * bud.heading) * alive_in_wind(bud.heading)
                            : 0;
            living_buds_ += bud.light > 0;
        }
    }
}

void GrowingTree::sum_up() {
    light_.assign(nodes_.size(), 0);
    size_.assign(nodes_.size(), 0);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        const Internode& node = nodes_[i];
        if (node.is_gone) continue;
        light_[i] += node.light;
        size_[i] += 1;
        for (int b = node.first_bud; b < node.first_bud + node.buds; ++b) light_[i] += buds_[b].light;
        if (node.parent < 0) continue;
        light_[node.parent] += light_[i];
        size_[node.parent] += size_[i];
    }
}

void GrowingTree::shed(int year, std::vector<voxels::ShadowGrid::Change>& changes) {
    bool has_fallen = false;
    for (Internode& node : nodes_) {
        if (node.is_gone) continue;
        for (int b = node.first_bud; b < node.first_bud + node.buds; ++b) {
            AxilBud& bud = buds_[b];
            if (year - node.born > p_.bud_life) bud.is_alive = false;
            const int child = bud.child;
            if (child < 0 || nodes_[child].is_gone || year - nodes_[child].born < kTenderYears) continue;
            if (light_[child] >= p_.shedding * static_cast<float>(size_[child])) continue;
            nodes_[child].is_gone = has_fallen = true;
            changes.push_back({nodes_[child].end, false});
        }
    }
    if (!has_fallen) return;
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
        if (nodes_[i].is_gone || !nodes_[nodes_[i].parent].is_gone) continue;
        nodes_[i].is_gone = true;
        changes.push_back({nodes_[i].end, false});
    }
    sum_up();
}

std::vector<GrowingTree::Shoot> GrowingTree::share(int year) {
    const float age = std::min(static_cast<float>(year) / static_cast<float>(std::max(p_.years - 1, 1)), 1.0F);
    const float lambda = p_.apical_young + (p_.apical_old - p_.apical_young) * age;
    std::vector<Shoot> shoots;
    std::vector<float> flow(nodes_.size(), 0);
    flow[0] = p_.vigour * light_[0];
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Internode& node = nodes_[i];
        if (node.is_gone || flow[i] <= 0) continue;
        const float main = lambda * (node.main >= 0 ? light_[node.main] : node.light);
        float all = main;
        const auto lateral = [&](const AxilBud& bud) {
            return (1 - lambda) * (bud.child >= 0 && !nodes_[bud.child].is_gone ? light_[bud.child] : bud.light);
        };
        for (int b = node.first_bud; b < node.first_bud + node.buds; ++b) all += lateral(buds_[b]);
        if (all <= 0) continue;
        const float unit = flow[i] / all;
        if (node.main >= 0)
            flow[node.main] = unit * main;
        else if (unit * main >= 1)
            shoots.push_back({static_cast<int>(i), node.heading, -1, unit * main});
        for (int b = node.first_bud; b < node.first_bud + node.buds; ++b) {
            AxilBud& bud = buds_[b];
            const float v = unit * lateral(bud);
            if (bud.child >= 0)
                flow[bud.child] = v;
            else if (v >= 1)
                shoots.push_back({static_cast<int>(i), bud.heading, b, v});
        }
    }
    return shoots;
}

glm::vec3 GrowingTree::next_heading(const Internode& from, const Shoot& shoot, const voxels::ShadowGrid& grid) const {
    const int order = from.order + (shoot.bud >= 0);
    const int index = static_cast<int>(nodes_.size());
    glm::vec3 to_light = grid.way_to_light(from.end + 0.5F * shoot.heading);
    const float length = glm::length(to_light);
    // Where light is even, it leads nowhere.
    to_light *= 1 / std::max(length, 0.04F);
    const glm::vec3 wandering{chance(index, 1), chance(index, 2), chance(index, 3)};
    const float rise = order == 0 ? p_.trunk_rise : p_.limb_rise;
    return glm::normalize(shoot.heading + p_.light_seeking * to_light + rise * kUp + p_.gnarl * wandering);
}

void GrowingTree::bear_buds(int index) {
    Internode& node = nodes_[index];
    node.first_bud = static_cast<int>(buds_.size());
    if (node.order == 0 && node.place < p_.bare_internodes) return;
    const float wide = glm::radians(p_.branch_angle_deg * (1 + 0.18F * chance(index, 4)));
    for (int k = 0; k < p_.laterals; ++k) {
        const float turn = 6.2831853F * static_cast<float>(k) / static_cast<float>(p_.laterals);
        glm::vec3 out = glm::angleAxis(turn, node.heading) * node.out;
        if (node.order > 0 && p_.flatness > 0) {
            const glm::vec3 side = across(glm::cross(node.heading, kUp), node.heading);
            const float left = (node.place + k) % 2 == 0 ? 1.0F : -1.0F;
            out = across(out + p_.flatness * (2 * left * side - out), node.heading);
        }
        AxilBud bud;
        bud.heading = std::cos(wide) * node.heading + std::sin(wide) * out;
        buds_.push_back(bud);
        ++node.buds;
    }
}

void GrowingTree::grow(const Shoot& shoot, const voxels::ShadowGrid& grid, int year,
                       std::vector<voxels::ShadowGrid::Change>& changes) {
    const int count = std::min(static_cast<int>(shoot.flow), p_.longest_shoot);
    const float length = std::min(shoot.flow / static_cast<float>(count), 1.4F);
    Shoot next = shoot;
    for (int k = 0; k < count; ++k) {
        const Internode from = nodes_[next.from];
        Internode node;
        node.heading = next_heading(from, next, grid);
        node.end = from.end + length * node.heading;
        node.parent = next.from;
        node.order = from.order + (next.bud >= 0);
        node.place = next.bud >= 0 ? 0 : from.place + 1;
        node.born = year;
        if (!grid.holds(node.end) || (from.parent >= 0 && node.end.y < kLeastHeight)) return;
        const glm::vec3 out = across(from.out, node.heading);
        node.out = glm::angleAxis(glm::radians(p_.divergence_deg), node.heading) * out;
        const int index = static_cast<int>(nodes_.size());
        if (next.bud >= 0)
            buds_[next.bud].child = index;
        else
            nodes_[next.from].main = index;
        nodes_.push_back(node);
        bear_buds(index);
        changes.push_back({node.end, true});
        next = {index, node.heading, -1, shoot.flow};
    }
}

void GrowingTree::live(const voxels::ShadowGrid& grid, int year, std::vector<voxels::ShadowGrid::Change>& changes) {
    sum_up();
    shed(year, changes);
    if (living_buds_ >= p_.most_buds) return;
    year_ = year;
    for (const Shoot& shoot : share(year)) grow(shoot, grid, year, changes);
}

TreeSkeleton GrowingTree::skeleton() const {
    std::vector<Internode> nodes = nodes_;
    for (Internode& node : nodes) node.end -= root_;
    return limbs_of(nodes, year_);
}

}  // namespace quadrat::synthesis::trees
