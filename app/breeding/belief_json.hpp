// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "breeding/pbil.hpp"
#include "breeding/random_search.hpp"

namespace quadrat::breeding {

// {"round":3,"locked":["trees"],"probability":{"trees":[0.5,…],"land":[…],"sky":[…]}}; exact.
std::string to_json(const PbilState& state);
std::string to_json(const RandomState& state);  // the same without probability

// Read for the genome that the state already has. Throw InputError naming source, the key, what is wrong and what would
// be right; the state is then as before.
void read_belief(std::string_view json, std::string_view source, PbilState& state);
void read_belief(std::string_view json, std::string_view source, RandomState& state);

// {"trees":[0.5,…],"land":[…],"sky":[…]}
std::string to_json(const genome::PerAspect<std::vector<double>>& probability);

}  // namespace quadrat::breeding
