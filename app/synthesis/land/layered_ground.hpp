// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/isosurface.hpp"

namespace quadrat::synthesis::land {

enum class Material : std::uint8_t { Air, Sand, Rock };

// Ground that a heightfield cannot hold: columns of layers, rock, sand and air in any order, over a rectangle of square
// cells. Over the last layer of a column there is air, under the bottom rock.
class LayeredGround {
  public:
    struct Layer {
        Material material = Material::Air;
        float top_m = 0;  // it reaches from the layer below, or the bottom, up to here
    };

    // All air. Lengths are more than 0.
    LayeredGround(int columns, int rows, float cell_m, float bottom_m);

    int columns() const { return layers_.columns; }
    int rows() const { return layers_.rows; }
    float cell_m() const { return cell_m_; }
    float bottom_m() const { return bottom_m_; }
    std::span<const Layer> column(int x, int y) const { return layers_.at(x, y); }

    Material at(int x, int y, float height_m) const;
    // What lies from one height to the other, whatever was there. Nothing lies below the bottom.
    void fill(int x, int y, float from_m, float to_m, Material material);

    // The top of what is not air, at or below a height; the bottom where all is air.
    float floor_m(int x, int y, float height_m) const;
    // The lowest underside over a height: of an overhang, a roof. Nothing there: 1e6.
    float ceiling_m(int x, int y, float height_m) const;

    double volume_m3(Material material) const;

    // Sand falls where nothing bears it, then slides to neighbours with room until none stands steeper than the slope,
    // or so many rounds have passed. No sand is lost.
    void settle(float slope, int rounds);

    // Rock that does not hang together with the bottom's through sides of cells becomes sand where it stands. step_m:
    // how far apart heights are looked at. Returns how much it was.
    double drop_loose_rock_m3(float step_m);

    // What is not air as a closed surface, rounded over a cell; in metres, x and z from the middle, z to the south, y
    // up.
    mesh::Surface surface() const;

  private:
    void drop_sand(int x, int y);
    void slide_from(int x, int y, float slope);
    double solid_m(int x, int y, float from_m, float to_m) const;

    mesh::Grid<std::vector<Layer>> layers_;
    float cell_m_;
    float bottom_m_;
};

}  // namespace quadrat::synthesis::land
