// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/flora.hpp"

namespace quadrat::synthesis::trees {
scene::Flora make_flora(const scene::TreeParameters& parameters, base::Seed) {
    scene::Flora flora;
    flora.spacing_m = parameters.spacing_m;
    return flora;
}
}  // namespace quadrat::synthesis::trees
