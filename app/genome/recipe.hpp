// SPDX-License-Identifier: Apache-2.0
// The room `genome`: what can vary, and in which words it is spoken of. The parameter table, words and languages,
// offers and picks, recipes and scene codes. Nothing here breeds (breeding) or knows what a parameter looks like
// (scene).
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/seed.hpp"
#include "genome/aspect.hpp"
#include "genome/offer.hpp"
#include "genome/parameter_table.hpp"

namespace quadrat::genome {

// All that is needed to grow one scene again. Written as JSON:
//   {"quadrat":"scene","version":1,"seeds":{"trees":"0123456789abcdef",…},"camera":"…","parameters":{"tree.type":4,…}}
struct Recipe {
    ParameterValues values;
    PerAspect<base::Seed> seeds;
    base::Seed flight;  // names the camera's path, the same for the four scenes of a round
    friend bool operator==(const Recipe&, const Recipe&) = default;
};

Recipe recipe_of(const Candidate& candidate, base::Seed flight);
Candidate candidate_of(const Recipe& recipe);  // grows the same; what it was bred from, bits or words, is not known

// Uniform over every range, whatever it looks like: for tests and benches. seed:N is breeding::seeded_scene().
Recipe random_recipe(base::Seed seed);

std::string to_json(const Recipe& recipe);  // exact: from_json(to_json(r)) == r

// Throws InputError naming source, the line or key, what is wrong and what would be right: malformed JSON, another
// version, an unknown parameter, a value outside its range. A parameter left out has its default.
Recipe from_json(std::string_view json, std::string_view source);

}  // namespace quadrat::genome
