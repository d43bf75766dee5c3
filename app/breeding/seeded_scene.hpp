// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/recipe.hpp"

namespace quadrat::breeding {

// The scene seed:N, from the same taste as what the exhibit offers: each aspect between an archetype and one of its
// neighbours in words, with the seed's own accidents. What lies outside that taste is reached by a scene file.
genome::Recipe seeded_scene(const WordMap& map, base::Seed seed);

}  // namespace quadrat::breeding
