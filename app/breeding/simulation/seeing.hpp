// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "breeding/session.hpp"
#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {

// The world that sees: visitors compare small pictures, not parameters. One aspect is compared at a time, in the
// landscape that the visitor has in mind. Whoever draws the pictures is handed in: breeding knows no pictures.
using Picture = std::vector<float>;  // two are as far apart as their root mean square difference

// An aspect to look at: grown in the landscape `in`, from these parameters and this seed.
struct Look {
    std::size_t visitor = 0;  // whose landscape
    genome::Aspect aspect = genome::Aspect::Trees;
    genome::Candidate in;  // whole, with the aspect in place
};
using Eyes = std::function<std::vector<Picture>(const std::vector<Look>&)>;

struct SeeingWorld {
    int visitors = 60;
    int rounds = 8;
    base::Seed seed{1};
    Noise noise = Noise::Mild;
};

// Of each round, over all visitors; distances are shares of that of a scene by chance within what archetypes span.
struct SeenRound {
    Estimate nearest;  // of the four to the wish of that round, root mean square over the aspects
    double apart = 0;  // two of the four, on average
};

enum class Seer { Belief, BiasedRandom };

// Visitors' taste drifts toward a second wish, what they have seen often bores them, one in five changes their mind in
// one aspect; picks are noisy as in the other worlds.
struct SeenWorld {
    std::vector<SeenRound> belief;
    std::vector<SeenRound> biased_random;
};
SeenWorld play_seeing(const SeeingWorld& world, const Eyes& eyes);
std::string table_of(const SeeingWorld& world, const SeenWorld& seen);

}  // namespace quadrat::breeding
