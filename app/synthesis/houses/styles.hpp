// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "base/seed.hpp"
#include "scene/land_parameters.hpp"
#include "scene/settlement.hpp"
#include "synthesis/houses/building.hpp"

namespace quadrat::synthesis::houses {

// What a house is for; where it stands follows from it.
enum class Use : std::uint8_t { Dwelling, Townhouse, Barn, Chapel, Mill, Lighthouse };
inline constexpr std::size_t kUses = 6;

// How many regions there are: alpine, nordic, mediterranean, savanna, half-timbered, Atlantic.
inline constexpr int kRegions = 6;

// The houses of one settlement. The first ones of a use are each of their own design; once there are as many as
// most_of(), later ones are like an earlier one.
class Stock {
  public:
    Stock(const scene::LandParameters& parameters, base::Seed seed);

    struct Offer {
        Use use = Use::Dwelling;
        Design design;
        base::Seed seed;
        int like = -1;  // an earlier building, by number
    };
    // What somebody would build, by a seed of their own.
    Offer draw(Use use, base::Seed own) const;
    // Its number.
    std::uint32_t take(Offer offer);
    // Those taken, in order; of those not raised yet, all but half_m is missing.
    const std::vector<scene::Building>& buildings() const { return buildings_; }
    const std::vector<Use>& uses() const { return uses_; }

    bool has_chimney(std::uint32_t building) const { return designs_[building].design.chimneys > 0; }
    // Makes what was taken; deterministic, in parallel.
    void raise();
    std::vector<scene::Building> raised() {
        raise();
        return std::move(buildings_);
    }

    static std::size_t most_of(Use use);

  private:
    Design design(Use use, base::Seed seed) const;

    scene::LandParameters parameters_;
    base::Seed seed_;
    std::vector<Offer> designs_;
    std::vector<scene::Building> buildings_;
    std::vector<Use> uses_;
    std::vector<std::vector<std::uint32_t>> of_use_;
};

// So many houses of each use, or as many as there are of it, raised: to be looked at.
Stock sample_stock(const scene::LandParameters& parameters, base::Seed seed, std::size_t of_each);

}  // namespace quadrat::synthesis::houses
