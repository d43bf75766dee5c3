// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/parameters.hpp"
#include "scene/settlement.hpp"
#include "synthesis/houses/building.hpp"

namespace quadrat::synthesis::houses {

// What a house is for; where it stands follows from it.
enum class Use : std::uint8_t { Dwelling, Townhouse, Barn, Chapel, Mill, Lighthouse };

// The buildings of one region, several of each use but the last three, which stand once.
struct Stock {
    std::vector<scene::Building> buildings;
    std::vector<Use> uses;  // of each
    // Those of a use, by number.
    std::vector<std::uint32_t> of(Use use) const;
};

// How many regions there are: alpine, nordic, mediterranean, savanna, half-timbered, Atlantic.
inline constexpr int kRegions = 6;

// Made of settle.* parameters; deterministic, in parallel.
Stock make_stock(const scene::LandParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::houses
