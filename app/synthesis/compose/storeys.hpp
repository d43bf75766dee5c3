// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis {

// A flora's species by number, storey by storey; without those that are another's form among neighbours.
struct Storeyed {
    std::vector<std::uint32_t> trees, shrubs, herbs;
};

inline Storeyed by_storey(const scene::Flora& flora) {
    Storeyed kinds;
    for (std::uint32_t i = 0; i < flora.species.size(); ++i) {
        if (flora.species[i].is_form) continue;
        switch (flora.species[i].storey) {
            case scene::Storey::Tree:
                kinds.trees.push_back(i);
                break;
            case scene::Storey::Shrub:
                kinds.shrubs.push_back(i);
                break;
            case scene::Storey::Herb:
                kinds.herbs.push_back(i);
                break;
        }
    }
    return kinds;
}

}  // namespace quadrat::synthesis
