// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "breeding/belief/aspect_belief.hpp"
#include "breeding/belief/layered_belief.hpp"
#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {

// {"blends":[0,-1.2,…],"near":{"mean":[…],"variance":[…],"evidence":-2.1},"anywhere":{…}, and once something was
// picked "winner":2,"shown":[{"parameters":[…],"words":[…]},…]}, exact; without the last brace, so that more may
// follow.
std::string begun_json(const LayeredBelief& belief);

// Throws InputError naming source, the key below place, what is wrong and what would be right: also what was kept with
// another word map that has more or fewer named scenes' axes.
LayeredBelief layered_from(const nlohmann::json& value, std::string_view source, const std::string& place,
                           const Atlas& atlas, std::size_t words);

// What was believed in words alone, as versions up to 1 kept it: blends are weighed by what their words are worth in
// that belief, and nothing personal is known yet.
LayeredBelief migrated(const AspectBelief& in_words, const WordMap& map, genome::Aspect aspect);

}  // namespace quadrat::breeding
