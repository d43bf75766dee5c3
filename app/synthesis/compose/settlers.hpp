// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/settle.hpp"
#include "synthesis/land/country.hpp"

namespace quadrat::synthesis {

// Brings a settlement to a land while it is made: see houses/settle.hpp.
class HouseBuilders : public land::Settlers {
  public:
    HouseBuilders(const scene::LandParameters& parameters, base::Seed seed) : parameters_(parameters), seed_(seed) {}
    void build(scene::Land& land) override;
    void keep_clear(const scene::Land& land, mesh::Field& to_edge_m) override;
    void paint(const scene::Land& land, mesh::Image& albedo) override;
    scene::Landmark landmark() const override;

  private:
    const scene::LandParameters& parameters_;
    base::Seed seed_;
    houses::Settled settled_;
};

}  // namespace quadrat::synthesis
