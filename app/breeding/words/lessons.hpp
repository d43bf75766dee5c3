// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "breeding/words/described_scene.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/word_answer.hpp"

namespace quadrat::breeding {

// What a site adds to the scenes that the default word map is trained on.
struct Lessons {
    std::vector<DescribedScene> curator;   // described by people who know; named ones are offered like archetypes
    std::vector<DescribedScene> visitors;  // by buttons; nameless, and trusted less
    friend bool operator==(const Lessons&, const Lessons&) = default;
};

// Answers about one scene are one example of each aspect that they speak of; the words it was grown from hold where
// nobody said otherwise. The newest kMostVisitorScenes of each aspect.
inline constexpr std::size_t kMostVisitorScenes = 400;
std::vector<DescribedScene> lessons_from(std::span<const genome::WordAnswer> answers);

// {"quadrat":"word map","version":1,"curator":[{"quadrat":"described",…},…],"visitors":[…]}, exact.
std::string to_json(const Lessons& lessons);

// Also reads a file of described scenes: those of a curator. Throws InputError as described_scenes_from does.
Lessons word_lessons_from(std::string_view json, std::string_view source);

// The default scenes and these.
WordMap map_of(const Lessons& lessons);

// What is odd about scenes that a map is to be trained on, a line each; the map stands it all. Scenes described alike
// that look different; fewer scenes of an aspect than it has words; words that never vary freely of one another.
std::vector<std::string> remarks_on(std::span<const DescribedScene> scenes);

enum class Worse { Refuse, Take };  // lessons by which scenes could be told from one another less well

struct Training {
    Lessons lessons;  // what the map was trained on: of each aspect the lessons wanted, or those of before
    WordMap map;
    std::vector<std::string> said;  // what was refused or got worse, and remarks; a line each
};

// Aspect by aspect. Nothing gets worse without a line about it.
Training train(const Lessons& wanted, const Lessons& before, const WordMap& map_before, Worse worse);

}  // namespace quadrat::breeding
