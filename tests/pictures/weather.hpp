// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "genome/parameter_rules.hpp"
#include "genome/recipe.hpp"

// Hours and weathers over one place, as parameters.
namespace quadrat::tests {

using Values = std::map<std::string, float>;

// Takes a command line's words apart: NAME=VALUE, and the rest in order.
inline std::vector<std::string> without_values(int argc, const char* const* argv, Values& values) {
    std::vector<std::string> rest;
    for (const std::string& word : std::vector<std::string>(argv + 1, argv + argc)) {
        const auto equals = word.find('=');
        if (equals == std::string::npos)
            rest.push_back(word);
        else
            values[word.substr(0, equals)] = std::strtof(word.c_str() + equals + 1, nullptr);
    }
    return rest;
}

inline void set_all(genome::Recipe& recipe, const Values& values) {
    for (const auto& [name, value] : values) {
        const auto id = genome::parameter_named(name);
        if (!id) throw std::runtime_error(name + " is not a parameter");
        recipe.values.set(*id, value);
    }
}

// One place; its land and what grows there go by the seed.
inline genome::Recipe place(std::uint64_t seed = 5) {
    genome::Recipe recipe;
    for (const genome::Aspect aspect : genome::kAspects) recipe.seeds[aspect] = base::Seed{seed}.child(name_of(aspect));
    recipe.flight = base::Seed{seed}.child("flight");
    set_all(recipe, {{"range.height_m", 220}, {"land.sea_level", 0.2F}});
    return recipe;
}

struct Hour {
    const char* name;
    Values values;
};

inline const std::vector<Hour>& hours() {
    static const std::vector<Hour> all{{"morning", {{"sun.elevation_deg", 14}, {"sun.azimuth_deg", 75}}},
                                       {"noon", {{"sun.elevation_deg", 60}, {"sun.azimuth_deg", 150}}},
                                       {"evening", {{"sun.elevation_deg", 5}, {"sun.azimuth_deg", -50}}},
                                       {"night", {{"night.share", 0.75F}}}};
    return all;
}

inline const std::vector<Hour>& weathers() {
    static const std::vector<Hour> all{
        {"clear", {{"cloud.cover", 0.08F}, {"cirrus.cover", 0.15F}}},
        {"fair", {{"cloud.cover", 0.42F}, {"cloud.billow", 0.8F}, {"cloud.sharpness", 0.7F}}},
        {"overcast", {{"cloud.cover", 0.95F}, {"cloud.sharpness", 0.2F}, {"cloud.thickness", 0.5F}}},
        {"storm",
         {{"cloud.cover", 0.9F},
          {"cloud.sharpness", 0.9F},
          {"cloud.thickness", 1},
          {"rain.share", 0.7F},
          {"cloud.roughness", 0.62F}}},
        {"fog", {{"mist.share", 0.8F}, {"mist.depth_m", 20}, {"cloud.cover", 0.3F}, {"haze.distance_m", 1200}}},
        {"snow", {{"snowfall.share", 0.6F}, {"cloud.cover", 0.85F}, {"haze.distance_m", 1500}}}};
    return all;
}

// The values of that name.
inline const Values& named(const std::vector<Hour>& all, const std::string& name) {
    for (const Hour& one : all)
        if (one.name == name) return one.values;
    throw std::runtime_error("there is no " + name);
}

}  // namespace quadrat::tests
