// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/nearest_words.hpp"

namespace quadrat::breeding {
namespace {

constexpr float kFirstStep = 0.4F;
constexpr float kLastStep = 0.05F;  // nobody says a word more exactly

struct Search {
    const WordMap& map;
    genome::Aspect aspect;
    const Farness& farness;
    genome::Description nearest;
    double least;

    double farness_of(const genome::Description& words) const {
        genome::ParameterValues values;
        map.realise(aspect, words, values);
        return farness(values);
    }
    bool try_out(const genome::Description& words) {
        const double far = farness_of(words);
        if (far >= least) return false;
        least = far;
        nearest = words;
        return true;
    }
};

}  // namespace

genome::Description nearest_words(const WordMap& map, genome::Aspect aspect, const genome::Description& words,
                                  const Farness& farness) {
    Search search{map, aspect, farness, words, 0};
    search.least = search.farness_of(words);
    for (const DescribedScene& scene : map.scenes()) {
        if (scene.aspect != aspect) continue;
        const genome::Description said = map.completed(scene.words);
        genome::Description tried = words;
        for (const genome::Word& word : genome::vocabulary(aspect)) tried.set(word.id, said[word.id]);
        search.try_out(tried);
    }
    for (float step = kFirstStep; step >= kLastStep;) {
        bool is_better = false;
        for (const genome::Word& word : genome::vocabulary(aspect))
            for (const float turn : {-step, step}) {
                genome::Description tried = search.nearest;
                tried.set(word.id, tried[word.id] + turn);
                is_better = search.try_out(tried) || is_better;
            }
        if (!is_better) step *= 0.5F;
    }
    return search.nearest;
}

genome::Description words_of_scene(const genome::ParameterValues& values, genome::Aspect aspect, const WordMap& map,
                                   const genome::Description& words) {
    const auto ids = parameters_of(aspect, genome::Genome::Full);
    return nearest_words(map, aspect, words, [&](const genome::ParameterValues& told) {
        double squares = 0;
        for (const genome::ParameterId id : ids) {
            const genome::Parameter& p = parameter(id);
            const double apart = static_cast<double>(told[id] - values[id]) / static_cast<double>(p.max - p.min);
            squares += apart * apart;
        }
        return squares;
    });
}

}  // namespace quadrat::breeding
