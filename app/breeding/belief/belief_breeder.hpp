// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "breeding/belief/aspect_belief.hpp"
#include "breeding/belief/layered_belief.hpp"
#include "breeding/belief/taste.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/offer.hpp"
#include "genome/words.hpp"

namespace quadrat::breeding {

// The belief breeder. In the whole table a wish lies on three levels: near named scenes, in words, and along detail
// axes; in the classic genome it lies in the 21 parameters themselves.
struct BeliefState {
    genome::Genome genome;
    WordMap map;
    WordRanges ranges{};
    genome::PerAspect<AspectBelief> aspects{};   // of the classic genome
    genome::PerAspect<LayeredBelief> layered{};  // of the whole table
    genome::PerAspect<base::Seed> inherited{};   // the accidents of the last winner of an aspect; once there is one
    genome::PerAspect<bool> locked{};
    int round = 1;
    // Nothing is learnt: what was named best stays, beside three that are drawn as the first four were.
    bool is_by_chance = false;
    friend bool operator==(const BeliefState&, const BeliefState&) = default;
};

// The site's taste, if it is known, is where the whole table's belief begins; a curator's ranges bound it.
BeliefState initial_belief(genome::Genome genome, const WordMap& map, const WordRanges& ranges = {},
                           const Taste& taste = {});

// Four candidates. The last winner of an aspect is among them as it was, seed and all; two of the others inherit its
// accidents, so that a tree one liked comes back as that tree, and one does not. The last winners of all aspects are
// one candidate: which, the seed and the round say.
genome::Offer propose(const BeliefState& state, base::Seed seed);

BeliefState learn(const BeliefState& state, const genome::Offer& offer, const genome::Pick& pick);

// The scene the visitor is believed to wish for: the belief's mean, with the accidents of what was picked. Aspects that
// were never judged are those of `otherwise`.
genome::Candidate wished(const BeliefState& state, const genome::Candidate& otherwise);

// Where the named scenes lie that the map was trained on, an aspect: what the first four are chosen from.
std::vector<Place> archetype_places(genome::Genome genome, genome::Aspect aspect, const WordMap& map);

// How far each parameter of the table went from one candidate to another beyond what their words ask for, as a share of
// its range. Both must have words.
std::vector<float> moved_beside_words(const WordMap& map, const genome::Candidate& before,
                                      const genome::Candidate& now);

}  // namespace quadrat::breeding
