// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// Leaves out the limbs that are not wanted, with all that they bear. is_wanted(limb, its index) is not asked of stems.
template <typename Wanted>
void prune(TreeSkeleton& skeleton, const Wanted& is_wanted) {
    std::vector<int> place(skeleton.limbs.size(), -1);
    std::vector<Limb> kept;
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
        Limb& limb = skeleton.limbs[i];
        if (limb.parent >= 0 && (place[limb.parent] < 0 || !is_wanted(limb, i))) continue;
        if (limb.parent >= 0) limb.parent = place[limb.parent];
        place[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(limb));
    }
    skeleton.limbs = std::move(kept);
    std::erase_if(skeleton.sites, [&](const Site& site) { return place[site.limb] < 0; });
    for (Site& site : skeleton.sites) site.limb = place[site.limb];
}

}  // namespace quadrat::synthesis::trees
