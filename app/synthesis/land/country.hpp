// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"
#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "scene/scene.hpp"

namespace quadrat::synthesis::land {

// What people make of a land while it is made.
class Settlers {
  public:
    virtual ~Settlers() = default;
    // Heights, water and roads are there: sets the settlement, adds lanes to the roads and levels the ground. Where it
    // leaves the settlement empty it changes nothing, and is not asked again.
    virtual void build(scene::Land& land) = 0;
    // Lowers the distances to what is kept clear of plants, see scene::kept_clear_of().
    virtual void keep_clear(const scene::Land& land, mesh::Field& to_edge_m) = 0;
    // Colours the ground about the houses, sRGB.
    virtual void paint(const scene::Land& land, mesh::Image& albedo) = 0;
    // What a flight turns to.
    virtual scene::Landmark landmark() const = 0;
};

// The whole land, as grow_land() promises it. settlers may be null.
scene::Land make_land(const scene::LandParameters& parameters, base::Seed seed, const scene::Fineness& fineness,
                      Settlers* settlers = nullptr);

}  // namespace quadrat::synthesis::land
