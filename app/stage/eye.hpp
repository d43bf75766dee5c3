// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <span>
#include <vector>

#include "genome/recipe.hpp"
#include "nursery/plot.hpp"
#include "stage/easel.hpp"

namespace quadrat::stage {

// What somebody sees of a landscape who glances at it: of a picture of 64 × 36 pixels the colour (OKLab) of each of
// 16 × 9 blocks, and how much lightness varies in it. Two sights are as far apart as their root mean square difference.
using Sight = std::vector<float>;

// Looks at many landscapes: grown coarsely on all cores, drawn one after another. Aspects that were looked at lately
// are not grown again. The same for the same landscape on one kind of GPU.
class Eye {
  public:
    Eye();
    std::vector<Sight> look(std::span<const genome::Recipe> landscapes);

  private:
    void grow_missing(std::span<const genome::Recipe> landscapes);
    std::shared_ptr<const scene::Scene> composed(const genome::Recipe& landscape) const;

    Easel easel_;
    std::map<nursery::AspectKey, nursery::Grown> grown_;
};

}  // namespace quadrat::stage
