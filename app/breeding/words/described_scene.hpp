// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "genome/parameter_table.hpp"
#include "genome/words.hpp"

namespace quadrat::breeding {

// One aspect of a scene and what somebody says of it: what a word map learns from.
struct DescribedScene {
    std::string name;  // "alpine firs"; empty for one that has none
    genome::Aspect aspect = genome::Aspect::Trees;
    genome::PartialDescription words{};  // of the aspect; a word left out is free
    genome::ParameterValues values;      // of the aspect
    double weight = 1;                   // > 0: how far to trust it, since people disagree
    friend bool operator==(const DescribedScene&, const DescribedScene&) = default;
};

// {"quadrat":"described","version":1,"aspect":"trees","scenes":[
//    {"name":"alpine firs","weight":1,"words":{"tall":0.6,…},"parameters":{"tree.type":4,…}},…],
//  "ends":{"tall":[{"tree.height_m":4,…},{"tree.height_m":30,…}],…}}
// A parameter left out has its default. An end is a scene with that word at -1 or +1 and the aspect's others at 0.
// Throws InputError naming source, the place, what is wrong and what would be right: an unknown word or parameter, one
// of another aspect, a value outside its range, another version.
std::vector<DescribedScene> described_scenes_from(std::string_view json, std::string_view source);

std::vector<DescribedScene> described_scenes_from(const nlohmann::json& file, std::string_view source);

// As described_scenes_from reads them, one file an aspect; exact.
std::string to_json(const std::vector<DescribedScene>& scenes, genome::Aspect aspect);

// The archetypes of an aspect, known by name, each looked at and found worth showing.
const std::vector<DescribedScene>& archetypes(genome::Aspect aspect);

// What the default word map is trained on: archetypes and word ends of all aspects.
const std::vector<DescribedScene>& default_scenes();

}  // namespace quadrat::breeding
