// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/seed.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {

// Shapes that noise alone does not make, each by its share and none below 0. Functions of the place and the height, so
// they are the same on any grid; those with a place of their own fade out before the land's border.
class Landforms {
  public:
    Landforms(const scene::LandParameters& parameters, base::Seed seed);

    // Islands, mesas, terraces, a volcano, towers of karst: heights above the country's lowest ground.
    void shape_ground(std::span<const float> xs_m, float z_m, std::span<float> heights_m) const;

    // A canyon, sea cliffs, marsh: heights above the sea.
    void shape_shore(std::span<const float> xs_m, float z_m, std::span<float> heights_m) const;

    // Dunes, which the wind heaps on ground that water has shaped already.
    void heap_dunes(std::span<const float> xs_m, float z_m, std::span<float> heights_m) const;

  private:
    using Row = std::span<const float>;
    using Heights = std::span<float>;
    void islands(Row xs_m, float z_m, Heights h) const;
    void mesas(Heights h) const;
    void terraces(Row xs_m, float z_m, Heights h) const;
    void cone(Row xs_m, float z_m, Heights h) const;
    void karst(Row xs_m, float z_m, Heights h) const;
    void canyon(Row xs_m, float z_m, Heights h) const;
    void cliffs(Heights h) const;
    void marsh(Row xs_m, float z_m, Heights h) const;

    scene::LandParameters p_;
    base::Seed seed_;
    noise::Key wander_;
    float side_ = 1;  // where chance puts what stands left or right
};

}  // namespace quadrat::synthesis::land
