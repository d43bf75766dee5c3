// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/coordinates.hpp"

namespace quadrat::breeding {

std::size_t dimensions_of(genome::Genome genome, genome::Aspect aspect) {
    return genome == genome::Genome::Full ? genome::vocabulary(aspect).size() : parameters_of(aspect, genome).size();
}

Axis axis_of(genome::Genome genome, genome::Aspect aspect, std::size_t index) {
    if (genome == genome::Genome::Full) return {genome::vocabulary(aspect)[index].name, -1, 1};
    const genome::Parameter& p = parameter(parameters_of(aspect, genome)[index]);
    return {p.name, p.min, p.max};
}

Place place_of(const genome::Description& words, genome::Aspect aspect) {
    Place place;
    for (const genome::Word& word : genome::vocabulary(aspect))
        place.push_back((static_cast<double>(words[word.id]) + 1) / 2);
    return place;
}

Place place_of(const genome::ParameterValues& values, genome::Genome genome, genome::Aspect aspect) {
    Place place;
    for (const genome::ParameterId id : parameters_of(aspect, genome)) {
        const genome::Parameter& p = parameter(id);
        place.push_back((static_cast<double>(values[id]) - p.min) / (static_cast<double>(p.max) - p.min));
    }
    return place;
}

Place place_of(const genome::Candidate& candidate, genome::Genome genome, genome::Aspect aspect) {
    return candidate.words ? place_of(*candidate.words, aspect) : place_of(candidate.values, genome, aspect);
}

std::vector<Place> named_places(std::span<const DescribedScene> scenes, genome::Genome genome, genome::Aspect aspect) {
    std::vector<Place> places;
    for (const DescribedScene& scene : scenes)
        if (!scene.name.empty() && scene.aspect == aspect) places.push_back(place_of(scene.values, genome, aspect));
    return places;
}

void set_words(genome::Description& words, genome::Aspect aspect, const Place& place) {
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t i = 0; i < vocabulary.size(); ++i)
        words.set(vocabulary[i].id, static_cast<float>(2 * place[i] - 1));
}

void set_values(genome::ParameterValues& values, genome::Genome genome, genome::Aspect aspect, const Place& place) {
    const auto ids = parameters_of(aspect, genome);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const genome::Parameter& p = parameter(ids[i]);
        values.set(ids[i], static_cast<float>(p.min + place[i] * (static_cast<double>(p.max) - p.min)));
    }
}

}  // namespace quadrat::breeding
