// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {

// How far parameters of an aspect are from what is looked for; not negative.
using Farness = std::function<double(const genome::ParameterValues&)>;

// The words of an aspect by which the map comes nearest to something: pattern search (Hooke & Jeeves 1961), from the
// nearest of the scenes it was trained on, or from where `words` stands. The other aspects' words stay as they are.
genome::Description nearest_words(const WordMap& map, genome::Aspect aspect, const genome::Description& words,
                                  const Farness& farness);

// What the map would have called an aspect of a scene; the other aspects' words stay as they are in `words`.
genome::Description words_of_scene(const genome::ParameterValues& values, genome::Aspect aspect, const WordMap& map,
                                   const genome::Description& words = {});

}  // namespace quadrat::breeding
