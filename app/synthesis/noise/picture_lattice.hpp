// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::noise {

// Grey pictures in place of noise: each octave repeats one of them, so that what a picture shows stands in the land at
// that octave's size. The first picture is the first octave and lies as it is; the last serves all octaves that are
// left, each turned, and moved by chance.
class PictureLattice {
  public:
    // Shares, 0 black to 1 white. One picture or more, each 2 samples a side or more, all of them numbers. A picture
    // whose opposite edges do not fit is blended over an eighth of its side until they do.
    explicit PictureLattice(const std::vector<mesh::Field>& pictures);

    // At a place in waves of the first octave: black is -1, white 1. step: the distance between samples, in the same
    // waves; pictures are no finer than it can hold. The octaves' basis and lacunarity are not looked at: a picture is
    // the basis, and each octave is twice as fine as the one before.
    float fbm(Key key, float x, float y, float step, const Octaves& octaves) const;

    // How many of the pictures had to be blended at their edges.
    int blended() const { return blended_; }

  private:
    using Finer = std::vector<mesh::Field>;  // a picture, then each half as large as the one before
    std::vector<Finer> pictures_;
    int blended_ = 0;
};

}  // namespace quadrat::synthesis::noise
