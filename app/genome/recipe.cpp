// SPDX-License-Identifier: Apache-2.0
#include "genome/recipe.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/parameter_rules.hpp"
#include "genome/values_json.hpp"

namespace quadrat::genome {
namespace {

constexpr int kVersion = 1;

void require_scene(const nlohmann::json& root, std::string_view source) {
    require_object(root, {"quadrat", "version", "seeds", "camera", "parameters"}, source, "the file");
    if (const auto& kind = member(root, "quadrat", source); kind != "scene")
        throw base::InputError(fmt::format("{}: quadrat is {}; it should be \"scene\"", source, brief(kind)));
    if (const auto& version = member(root, "version", source); version != kVersion)
        throw base::InputError(
            fmt::format("{}: version is {}; this program reads version {}", source, brief(version), kVersion));
}

}  // namespace

Recipe recipe_of(const Candidate& candidate, base::Seed flight) { return {candidate.values, candidate.seeds, flight}; }

Candidate candidate_of(const Recipe& recipe) {
    Candidate candidate;
    candidate.values = recipe.values;
    candidate.seeds = recipe.seeds;
    return candidate;
}

Recipe random_recipe(base::Seed seed) {
    Recipe recipe;
    for (const Parameter& p : parameter_table()) {
        base::RandomStream chance(seed.child("parameter").child(p.name));
        const bool is_whole = p.unit.empty() || p.unit == kChoice;
        const auto steps = static_cast<std::uint32_t>(p.max - p.min) + 1U;
        recipe.values.set(p.id,
                          is_whole ? p.min + static_cast<float>(chance.below(steps)) : chance.between(p.min, p.max));
    }
    for (const Aspect aspect : kAspects) {
        make_consistent(aspect, recipe.values);
        recipe.seeds[aspect] = seed.child(name_of(aspect));
    }
    recipe.flight = seed.child("flight");
    return recipe;
}

std::string to_json(const Recipe& recipe) {
    return fmt::format(R"({{"quadrat":"scene","version":{},"seeds":{},"camera":"{}","parameters":{}}})", kVersion,
                       seeds_json(recipe.seeds), text_of(recipe.flight), values_json(recipe.values));
}

Recipe from_json(std::string_view json, std::string_view source) {
    const nlohmann::json root = parse_json(json, source);
    require_scene(root, source);
    Recipe recipe;
    recipe.values = values_from(member(root, "parameters", source), source, "parameters");
    recipe.seeds = seeds_from(member(root, "seeds", source), source, "seeds");
    recipe.flight = seed_from(member(root, "camera", source), source, "camera");
    return recipe;
}

}  // namespace quadrat::genome
