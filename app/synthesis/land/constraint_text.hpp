// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

#include "synthesis/land/field_methods.hpp"

// What people write down of a field that they know in part. A line of text each; what follows a # is left out, and so
// are empty lines. Both throw base::InputError "SOURCE:LINE: what is wrong and what would be right".
namespace quadrat::synthesis::land {

// column row height
std::vector<FixedPoint> fixed_points_from(std::string_view text, std::string_view source);

// ridge|river column row height column row height …, two corners or more
std::vector<Line> lines_from(std::string_view text, std::string_view source);

}  // namespace quadrat::synthesis::land
