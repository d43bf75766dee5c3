// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <numeric>

namespace quadrat::synthesis {
namespace {

constexpr std::size_t kSides = 16;       // that a neighbour may stand on
constexpr std::size_t kClosed = 13;      // of them taken: the middle of a stand
constexpr std::size_t kOpen = 5;         // and no more: it stands alone
constexpr float kReach = 1.15F;          // to both crowns together, that a neighbour shades from
constexpr float kLeastScale = 0.6F;      // of a neighbour to a tree: one far smaller stands in its shade
constexpr float kLeastOneSided = 0.35F;  // of the open sides' mean direction: gaps all around make no edge

glm::vec2 way_of(std::size_t side) {
    const float turn = 6.2831853F * (static_cast<float>(side) + 0.5F) / kSides;
    return {std::cos(turn), std::sin(turn)};
}

class Neighbours {
  public:
    Neighbours(const std::vector<Candidate>& trees, const scene::Flora& flora)
        : trees_(trees), flora_(flora), by_x_(trees.size()) {
        std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
        std::ranges::sort(by_x_, {}, [&](std::size_t i) { return std::pair{trees[i].at_m.x, i}; });
        for (const Candidate& tree : trees) most_crown_m_ = std::max(most_crown_m_, crown_m(tree));
    }

    std::bitset<kSides> taken_about(const Candidate& tree) const {
        std::bitset<kSides> taken;
        const float reach_m = kReach * (crown_m(tree) + most_crown_m_);
        const auto first =
            std::ranges::lower_bound(by_x_, tree.at_m.x - reach_m, {}, [&](std::size_t i) { return trees_[i].at_m.x; });
        for (auto it = first; it != by_x_.end() && trees_[*it].at_m.x <= tree.at_m.x + reach_m; ++it) {
            const Candidate& other = trees_[*it];
            const glm::vec2 to_m = other.at_m - tree.at_m;
            const float away_m = glm::length(to_m);
            if (away_m <= 0 || away_m > kReach * (crown_m(tree) + crown_m(other))) continue;
            if (flora_.species[other.species].height_m * other.scale <
                kLeastScale * flora_.species[tree.species].height_m * tree.scale)
                continue;
            const float least_cosine = std::cos(std::min(std::atan2(crown_m(other), away_m) + 0.2F, 1.5F));
            for (std::size_t side = 0; side < kSides; ++side)
                if (glm::dot(way_of(side), to_m) > least_cosine * away_m) taken.set(side);
        }
        return taken;
    }

  private:
    float crown_m(const Candidate& c) const { return flora_.species[c.species].crown_radius_m * c.scale; }

    const std::vector<Candidate>& trees_;
    const scene::Flora& flora_;
    std::vector<std::size_t> by_x_;
    float most_crown_m_ = 0;
};

}  // namespace

void grow_among_neighbours(std::vector<Candidate>& trees, const scene::Flora& flora) {
    if (std::ranges::none_of(flora.species, [](const scene::Species& s) { return s.in_stand >= 0; })) return;
    const std::vector<Candidate> alone = trees;
    const Neighbours neighbours(alone, flora);
    for (Candidate& tree : trees) {
        const scene::Species& species = flora.species[tree.species];
        if (species.in_stand < 0 || tree.mark == 0) continue;
        const std::bitset<kSides> taken = neighbours.taken_about(tree);
        if (taken.count() >= kClosed) {
            tree.species = static_cast<std::uint32_t>(species.in_stand);
            continue;
        }
        if (taken.count() <= kOpen) continue;
        glm::vec2 open{0};
        for (std::size_t side = 0; side < kSides; ++side)
            if (!taken.test(side)) open += way_of(side) / static_cast<float>(kSides - taken.count());
        if (glm::length(open) < kLeastOneSided) continue;
        tree.species = static_cast<std::uint32_t>(species.at_edge);
        // Counter-clockwise seen from above: +x toward -z.
        tree.yaw_rad = std::atan2(-open.y, open.x);
    }
}

}  // namespace quadrat::synthesis
