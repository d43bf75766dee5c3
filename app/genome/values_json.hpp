// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/seed.hpp"
#include "genome/aspect.hpp"
#include "genome/parameter_table.hpp"

namespace quadrat::genome {

// The pieces that scenes, offers and the breeding protocol share. Each reader throws InputError naming source, place
// (the key that holds the value), what is wrong and what would be right.

std::string values_json(const ParameterValues& values);                 // {"tree.type":4,…}, every parameter
std::string values_json(const ParameterValues& values, Genome genome);  // only those of the genome
std::string seeds_json(const PerAspect<base::Seed>& seeds);             // {"trees":"0123456789abcdef",…}

// A parameter left out has its default; an unknown one, or a value outside its range, is an error.
ParameterValues values_from(const nlohmann::json& value, std::string_view source, std::string_view place);
PerAspect<base::Seed> seeds_from(const nlohmann::json& value, std::string_view source, std::string_view place);
base::Seed seed_from(const nlohmann::json& value, std::string_view source, std::string_view place);

}  // namespace quadrat::genome
