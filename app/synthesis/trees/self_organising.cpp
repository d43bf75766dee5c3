// SPDX-License-Identifier: Apache-2.0
// A stand shares one shadow grid (Palubicki et al. 2009, section 5; before it Měch & Prusinkiewicz, "Visual models of
// plants interacting with their environment", SIGGRAPH 1996). The grid stands still while trees live their year, so
// that their order does not matter.
#include "synthesis/trees/self_organising.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "synthesis/trees/growing_tree.hpp"

namespace quadrat::synthesis::trees {
namespace {

constexpr float kReach = 30;  // internodes, that a crown may reach to the side
constexpr int kHighest = 64;

voxels::ShadowGrid grid_about(std::span<const Seedling> seedlings, const voxels::ShadowGrid::Shade& shade) {
    glm::vec2 low{0};
    glm::vec2 high{0};
    for (const Seedling& seedling : seedlings) {
        low = glm::min(low, seedling.at);
        high = glm::max(high, seedling.at);
    }
    low -= kReach;
    high += kReach;
    const glm::vec2 size = glm::ceil(high - low);
    return voxels::ShadowGrid(shade, {low.x, 0, low.y}, {static_cast<int>(size.x), kHighest, static_cast<int>(size.y)});
}

}  // namespace

std::vector<TreeSkeleton> grow_together(const SelfOrganisation& p, std::span<const Seedling> seedlings,
                                        base::Seed seed) {
    voxels::ShadowGrid grid = grid_about(seedlings, p.shade);
    std::vector<GrowingTree> trees;
    trees.reserve(seedlings.size());
    for (std::size_t i = 0; i < seedlings.size(); ++i) trees.emplace_back(p, seedlings[i], seed.child(i));
    std::vector<std::vector<voxels::ShadowGrid::Change>> changes(trees.size());
    std::vector<voxels::ShadowGrid::Change> all;
    for (int year = 0; year < p.years; ++year) {
        const auto live = [&](std::size_t i) {
            changes[i].clear();
            trees[i].sense(grid);
            trees[i].live(grid, year, changes[i]);
        };
        if (trees.size() == 1)
            live(0);
        else
            oneapi::tbb::parallel_for(std::size_t{0}, trees.size(), live);
        all.clear();
        for (const auto& own : changes) all.insert(all.end(), own.begin(), own.end());
        grid.apply(all);
    }
    std::vector<TreeSkeleton> grown(trees.size());
    oneapi::tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t i) { grown[i] = trees[i].skeleton(); });
    return grown;
}

std::vector<Seedling> stand_of_seedlings(float apart, base::Seed seed) {
    std::vector<Seedling> seedlings;
    for (int row = 0; row < kStandSide; ++row) {
        for (int column = 0; column < kStandSide; ++column) {
            base::RandomStream random{seed.child("seedling").child(seedlings.size())};
            const glm::vec2 place = glm::vec2{column, row} - 0.5F * (kStandSide - 1);
            const glm::vec2 off{random.between(-0.15F, 0.15F), random.between(-0.15F, 0.15F)};
            seedlings.push_back({apart * (place + off), {0, 0}});
        }
    }
    return seedlings;
}

}  // namespace quadrat::synthesis::trees
