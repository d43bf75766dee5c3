// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/trees/growing_tree.hpp"

namespace quadrat::synthesis::trees {
namespace {

using Internodes = std::vector<GrowingTree::Internode>;

constexpr int kLeafYears = 3;
constexpr int kMostPassed = 2;       // internodes that one length of a limb's mesh may stand for, besides its own
constexpr float kStraight = 0.955F;  // cosine

class Limber {
  public:
    Limber(const Internodes& nodes, int year) : nodes_(nodes), year_(year), bears_(nodes.size(), 0) {
        heir_.assign(nodes.size(), -1);
        for (std::size_t i = nodes.size(); i-- > 1;) {
            if (nodes[i].is_gone) continue;
            bears_[i] += 1;
            bears_[nodes[i].parent] += bears_[i];
        }
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (!nodes[i].is_gone && weight(static_cast<int>(i)) > weight(heir_[nodes[i].parent]))
                heir_[nodes[i].parent] = static_cast<int>(i);
        is_fork_.assign(nodes.size(), false);
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (!nodes[i].is_gone && heir_[nodes[i].parent] != static_cast<int>(i) && !is_twig(static_cast<int>(i)))
                is_fork_[nodes[i].parent] = true;
        for (const auto& node : nodes) at_.push_back(node.end);
        for (int pass = 0; pass < 2; ++pass) smooth();
    }

    TreeSkeleton limbs() {
        TreeSkeleton made;
        limb_of_.assign(nodes_.size(), -1);
        node_of_.assign(nodes_.size(), 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i) begin_limb(made, static_cast<int>(i));
        for (std::size_t i = 1; i < nodes_.size(); ++i) bear_leaves(made, static_cast<int>(i));
        measure(made);
        return made;
    }

  private:
    // An axis goes on in itself unless a lateral has clearly outgrown it.
    float weight(int i) const {
        if (i < 0) return 0;
        const bool is_main = nodes_[nodes_[i].parent].main == i;
        return static_cast<float>(bears_[i]) * (is_main ? 1.3F : 1.0F);
    }
    bool is_twig(int i) const { return bears_[i] < 2; }

    // Neither the end nor a fork nor a bend: a node less to draw.
    bool is_plain(int k, const glm::vec3& last) const {
        if (heir_[k] < 0 || is_fork_[k]) return false;
        const glm::vec3 to = at_[k] - last;
        const glm::vec3 on = at_[heir_[k]] - at_[k];
        return glm::dot(to, on) > kStraight * glm::length(to) * glm::length(on);
    }

    // What a year's step leaves as a corner is a bend in grown wood.
    void smooth() {
        std::vector<glm::vec3> smoothed = at_;
        for (std::size_t i = 1; i < nodes_.size(); ++i)
            if (heir_[i] >= 0) smoothed[i] = 0.5F * at_[i] + 0.25F * (at_[nodes_[i].parent] + at_[heir_[i]]);
        at_ = std::move(smoothed);
    }

    void begin_limb(TreeSkeleton& made, int first) {
        const int parent = nodes_[first].parent;
        if (nodes_[first].is_gone || (parent >= 0 && (heir_[parent] == first || is_twig(first)))) return;
        if (parent < 0 && heir_[first] < 0) return;
        Limb limb;
        const auto index = static_cast<int>(made.limbs.size());
        if (parent >= 0) {
            limb.parent = limb_of_[parent];
            limb.parent_node = node_of_[parent];
            limb.order = made.limbs[limb.parent].order + 1;
            limb.nodes.push_back({at_[parent], 0.01F, 0, 0});
        }
        int passed = 0;
        for (int k = first; k >= 0; k = heir_[k]) {
            limb_of_[k] = index;
            if (passed < kMostPassed && !limb.nodes.empty() && is_plain(k, limb.nodes.back().at_m)) {
                node_of_[k] = static_cast<int>(limb.nodes.size()) - 1;
                ++passed;
                continue;
            }
            passed = 0;
            node_of_[k] = static_cast<int>(limb.nodes.size());
            limb.nodes.push_back({at_[k], 0.01F, 0, 0});
        }
        made.limbs.push_back(std::move(limb));
    }

    void bear_leaves(TreeSkeleton& made, int i) const {
        const GrowingTree::Internode& node = nodes_[i];
        if (node.is_gone || year_ - node.born >= kLeafYears) return;
        const int on = limb_of_[i] >= 0 ? i : node.parent;
        if (limb_of_[on] < 0) return;
        Site site;
        site.at_m = at_[i];
        site.along = node.heading;
        site.out = node.out;
        site.limb = limb_of_[on];
        site.node = node_of_[on];
        made.sites.push_back(site);
    }

    const Internodes& nodes_;
    int year_;
    std::vector<int> bears_;  // internodes, itself among them
    std::vector<int> heir_;
    std::vector<bool> is_fork_;
    std::vector<glm::vec3> at_;
    std::vector<int> limb_of_, node_of_;
};

}  // namespace

TreeSkeleton limbs_of(const Internodes& nodes, int year) { return Limber(nodes, year).limbs(); }

}  // namespace quadrat::synthesis::trees
