// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {

// A word that is not in the vocabulary, told by people who described scenes with it: a direction among the words of its
// aspect. What it asks for is the most usual scene that lies so far along it.
struct OwnWord {
    static constexpr std::size_t kFewestScenes = 10;

    std::string name;
    genome::Aspect aspect = genome::Aspect::Land;
    Direction direction;        // one weight a word of the aspect, in vocabulary order; the value is that of `constant`
    double constant = 0;        // the word's value where all others are 0
    double leave_one_out = 0;   // how far off a scene's value is when told from the other scenes
    double spread_of_said = 0;  // the deviation of what was said: without the words one would be off by so much

    // The word at so much, from -1 to 1, as it can be asked of a map.
    Direction at(double value) const;
};

// {"quadrat":"own word","version":1,"name":"spooky","aspect":"sky","scenes":[
//    {"value":0.8,"words":{"misty":0.5,…}},        what the scene is called; words left out follow from the others
//    {"value":-0.4,"parameters":{"sky.haze":…}},   or the scene itself, which the map then describes
//    … ten at least]}
// Least squares with a ridge, chosen by generalised cross-validation: ten scenes of seven words leave doubt. Throws
// InputError naming source, the place, what is wrong and what would be right: too few scenes, a name that is a word
// already, values all alike, and what described scenes can have.
OwnWord own_word_from(std::string_view json, std::string_view source, const WordMap& map);

}  // namespace quadrat::breeding
