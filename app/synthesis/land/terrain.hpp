// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "base/seed.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/landforms.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {

// The height of a country as a function of place, for the land and for what surrounds it. Composed for a viewer who
// stands in the south and looks about north: raised ground to stand on, a hollow before it that the sea may fill,
// flanks that rise, and a range that closes the view.
class Terrain {
  public:
    Terrain(const scene::LandParameters& parameters, base::Seed seed);

    // Heights above the sea's surface along a row of places, no finer than a grid of this cell can hold.
    void heights_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const;

    // To be added to heights on the land after streams and slides have done their work.
    void heap_dunes(std::span<const float> xs_m, float z_m, std::span<float> heights_m) const {
        landforms_.heap_dunes(xs_m, z_m, heights_m);
    }

  private:
    void add_ranges(std::span<const float> xs_m, float z_m, std::span<float> out) const;
    void add_far_range(std::span<const float> xs_m, float z_m, float height_m, std::span<float> out) const;
    void above_lowest_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const;
    float sea_level_m() const;
    void lower_outskirts(std::span<const float> xs_m, float z_m, std::span<float> out) const;
    void add_hills(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const;

    scene::LandParameters parameters_;
    Landforms landforms_;
    noise::Key hills_;
    noise::Key folds_;
    noise::Key bends_;
    noise::Key range_;
    float rugged_ = 0;  // 0 rolling to 1 ridged
    float noise_relief_m_ = 0;
    float form_relief_m_ = 0;
    float sea_m_ = 0;  // the sea's surface
    float valley_phase_ = 0;
};

}  // namespace quadrat::synthesis::land
