// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/questions.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace quadrat::breeding {

Point halton(std::size_t index, std::size_t dimensions) {
    constexpr std::array<std::size_t, 12> kPrimes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    assert(dimensions <= kPrimes.size());
    Point point;
    for (std::size_t d = 0; d < dimensions; ++d) {
        double value = 0;
        double place = 1.0 / static_cast<double>(kPrimes[d]);
        for (std::size_t left = index + 1; left > 0; left /= kPrimes[d], place /= static_cast<double>(kPrimes[d]))
            value += place * static_cast<double>(left % kPrimes[d]);
        point.push_back(value);
    }
    return point;
}

namespace {

void set_point(genome::Description& words, genome::Aspect aspect, std::size_t index) {
    const auto vocabulary = genome::vocabulary(aspect);
    const Point point = halton(index, vocabulary.size());
    for (std::size_t w = 0; w < vocabulary.size(); ++w)
        words.set(vocabulary[w].id, static_cast<float>(2 * point[w] - 1));
}

}  // namespace

genome::Candidate landscape_to_describe(const WordMap& map, std::size_t index, base::Seed seed) {
    constexpr std::size_t kApart = 409;
    genome::Candidate candidate;
    candidate.words.emplace();
    for (const genome::Aspect aspect : genome::kAspects) {
        set_point(*candidate.words, aspect, index + kApart * static_cast<std::size_t>(aspect));
        map.realise(aspect, *candidate.words, candidate.values);
        candidate.seeds[aspect] = seed.child(genome::name_of(aspect));
    }
    return candidate;
}

std::vector<DescribedScene> scenes_to_describe(const WordMap& map, genome::Aspect aspect, std::size_t first,
                                               std::size_t count) {
    std::vector<DescribedScene> scenes;
    for (std::size_t i = first; i < first + count; ++i) {
        genome::Description words;
        set_point(words, aspect, i);
        DescribedScene& scene = scenes.emplace_back();
        scene.name = fmt::format("question {}", i + 1);
        scene.aspect = aspect;
        map.realise(aspect, words, scene.values);
    }
    return scenes;
}

}  // namespace quadrat::breeding
