// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

// Adds one more level to a crown, where these masses, its levels from the finest on, end with more triangles: a ball
// that reaches as far as the crown does each way. A crown with holes and arms cannot be made simpler edge by edge, and
// a forest has hundreds that are a dozen pixels high.
enum class Ball { Of32, Of8 };  // triangles
void add_ball(std::vector<scene::CrownMass>& masses, Ball ball);

}  // namespace quadrat::synthesis::trees
