// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "base/clock.hpp"
#include "genome/recipe.hpp"
#include "scene/scene.hpp"

namespace quadrat::nursery {

using Scenes = std::vector<std::shared_ptr<const scene::Scene>>;

// Landscapes that belong together on the screen: four candidates, or one finale; and what they are grown from.
struct Act {
    Scenes scenes;
    std::vector<genome::Recipe> recipes;
    int number = 0;            // counts the acts of this run, from 1
    base::Instant arrived{0};  // when it was first to be seen
};

}  // namespace quadrat::nursery
