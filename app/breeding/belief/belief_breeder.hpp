// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "breeding/belief/aspect_belief.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/offer.hpp"
#include "genome/words.hpp"

namespace quadrat::breeding {

// What a curator allows of a word; low == high locks it there.
struct WordRange {
    float low = -1;
    float high = 1;
    friend bool operator==(const WordRange&, const WordRange&) = default;
};
using WordRanges = std::array<WordRange, genome::kWordCount>;

// The belief breeder. In the whole table a wish lies in words, and parameters follow from them by the word map; in the
// classic genome it lies in the 21 parameters themselves.
struct BeliefState {
    genome::Genome genome;
    WordMap map;
    WordRanges ranges{};
    genome::PerAspect<AspectBelief> aspects{};
    genome::PerAspect<base::Seed> inherited{};  // the accidents of the last winner of an aspect; once there is one
    genome::PerAspect<bool> locked{};
    int round = 1;
    friend bool operator==(const BeliefState&, const BeliefState&) = default;
};

BeliefState initial_belief(genome::Genome genome, const WordMap& map);

// Four candidates. The last winner of an aspect is among them as it was, seed and all; two of the others inherit its
// accidents, so that a tree one liked comes back as that tree, and one does not.
genome::Offer propose(const BeliefState& state, base::Seed seed);

BeliefState learn(const BeliefState& state, const genome::Offer& offer, const genome::Pick& pick);

// The scene the visitor is believed to wish for: the belief's mean, with the accidents of what was picked. Aspects that
// were never judged are those of `otherwise`.
genome::Candidate wished(const BeliefState& state, const genome::Candidate& otherwise);

// The parameters of an aspect that has these words and grows by this seed: what the word map says, and within what it
// leaves open, the seed's own accidents.
void realise(const WordMap& map, genome::Aspect aspect, const genome::Description& words, base::Seed seed,
             genome::ParameterValues& values);

// Where the named scenes lie that the map was trained on, an aspect: what the first four are chosen from.
std::vector<Place> archetype_places(genome::Genome genome, genome::Aspect aspect, const WordMap& map);

}  // namespace quadrat::breeding
