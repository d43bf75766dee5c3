// SPDX-License-Identifier: Apache-2.0
#include "breeding/seeded_scene.hpp"

#include <algorithm>

#include "breeding/belief/belief_breeder.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/belief/four_means.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::breeding {
namespace {

constexpr std::size_t kNeighbours = 5;
constexpr double kFarthest = 0.4;  // of the way to the neighbour: nearer to the archetype than to it
constexpr double kStray = 0.02;    // deviation, of a word's range
constexpr float kOwn = 0.03F;      // deviation, of a parameter's range

Place place_for(const std::vector<Place>& archetypes, base::RandomStream& chance) {
    const Place& from = archetypes[chance.below(static_cast<std::uint32_t>(archetypes.size()))];
    std::vector<Place> near = archetypes;
    std::ranges::stable_sort(near, {},
                             [&](const Place& place) { return squared_distance(place, from); });  // the first is `from`
    const std::size_t others = std::min(kNeighbours, near.size() - 1);
    const Place& to = near[others == 0 ? 0 : 1 + chance.below(static_cast<std::uint32_t>(others))];
    const double way = kFarthest * chance.unit();
    Place place;
    for (std::size_t i = 0; i < from.size(); ++i)
        place.push_back(
            std::clamp(from[i] + way * (to[i] - from[i]) + kStray * static_cast<double>(chance.normal()), 0.0, 1.0));
    return place;
}

// Two seeds of the same words are not the same scene.
void stray(genome::Aspect aspect, base::Seed seed, genome::ParameterValues& values) {
    for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full)) {
        const genome::Parameter& p = parameter(id);
        if (p.unit == genome::kChoice) continue;
        base::RandomStream chance(seed.child(p.name));
        values.set(id, values[id] + kOwn * chance.normal() * (p.max - p.min));
    }
    genome::make_consistent(aspect, values);
}

}  // namespace

genome::Recipe seeded_scene(const WordMap& map, base::Seed seed) {
    genome::Recipe recipe;
    genome::Description words;
    for (const genome::Aspect aspect : genome::kAspects) {
        recipe.seeds[aspect] = seed.child(name_of(aspect));
        const auto archetypes = archetype_places(genome::Genome::Full, aspect, map);
        if (archetypes.empty()) continue;
        base::RandomStream chance{recipe.seeds[aspect].child("words")};
        set_words(words, aspect, place_for(archetypes, chance));
        map.realise(aspect, words, recipe.values);
        stray(aspect, recipe.seeds[aspect].child("stray"), recipe.values);
    }
    recipe.flight = seed.child("flight");
    return recipe;
}

}  // namespace quadrat::breeding
