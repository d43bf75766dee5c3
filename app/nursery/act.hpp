// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/clock.hpp"
#include "genome/recipe.hpp"
#include "nursery/ahead.hpp"

namespace quadrat::nursery {

// Landscapes that belong together on the screen: four candidates, or one finale; and what they are grown from.
struct Act {
    Scenes scenes;
    std::vector<genome::Recipe> recipes;
    int number = 0;            // counts the acts of this run, from 1
    base::Instant arrived{0};  // when it was first to be seen
};

}  // namespace quadrat::nursery
