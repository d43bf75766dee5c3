// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

// Rings of vertices about a crown's axis, and a point below and above.
struct Outline {
    std::size_t rings;    // at least 2
    std::size_t corners;  // of a ring
    std::size_t triangles() const { return 2 * rings * corners; }
};
inline constexpr Outline kRoundOutline{3, 5};
inline constexpr Outline kPlainOutline{2, 4};

// Adds one more level to a crown, where these masses, its levels from the finest on, end with more triangles: rings
// that lie as far from its axis as the crown does at their height, so that a spire stays one. A crown with holes and
// arms cannot be made simpler edge by edge, and a forest has hundreds that are a dozen pixels high.
void add_outline(std::vector<scene::CrownMass>& masses, const Outline& outline);

}  // namespace quadrat::synthesis::trees
