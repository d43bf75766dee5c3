// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/parameters.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {

// The height of a country as a function of place, for the land and for what surrounds it. Composed for a viewer who
// stands in the south and looks about north: raised ground to stand on, a hollow before it that the sea may fill,
// flanks that rise, and a range that closes the view.
class Terrain {
  public:
    Terrain(const scene::LandParameters& parameters, base::Seed seed);

    float height_m(float x_m, float z_m) const;  // above the sea's surface

    // The same, smoothed to what a grid of this cell can hold.
    float height_m(float x_m, float z_m, float cell_m) const;

  private:
    float composed(float u, float v) const;
    float ranges_m(float x_m, float z_m) const;

    scene::LandParameters parameters_;
    noise::Key hills_;
    noise::Key bends_;
    noise::Key range_;
    float rugged_ = 0;  // 0 rolling to 1 ridged
    float noise_relief_m_ = 0;
    float form_relief_m_ = 0;
    float sea_m_ = 0;  // the sea's surface above the country's lowest ground
    float valley_phase_ = 0;
};

}  // namespace quadrat::synthesis::land
