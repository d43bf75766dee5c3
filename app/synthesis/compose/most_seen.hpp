// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "synthesis/compose/competition.hpp"
#include "synthesis/compose/site.hpp"

namespace quadrat::synthesis {

// Keeps so many of the plants, those that matter most to the picture: near ones, in view, then the rest by chance.
void keep_most_seen(const Sight& sight, std::vector<Candidate>& plants, std::size_t most);

}  // namespace quadrat::synthesis
