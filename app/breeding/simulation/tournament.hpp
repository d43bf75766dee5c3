// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <vector>

#include "breeding/simulation/player.hpp"

namespace quadrat::breeding {

inline constexpr std::array kRoundsReported{3, 5, 8, 15};

// A number and its standard error.
struct Estimate {
    double value = 0;
    double error = 0;
};
Estimate mean_of(const std::vector<double>& numbers);

// Who presses.
enum class Party {
    One,
    Drifting,  // one who comes to wish half of all parameters as another one does, round by round
    Group      // three who take turns, a round each, each with a wish
};
std::string_view name_of(Party party);
inline constexpr int kInAGroup = 3;

struct Tournament {
    genome::Genome genome = genome::Genome::Classic;
    World world = World::NearArchetypes;
    Noise noise = Noise::Mild;
    Party party = Party::One;
    int visitors = 200;
    int rounds = 15;
    base::Seed seed{1};
};

// What one visitor made of one method.
struct Played {
    std::vector<double> closeness;  // after each round
    int worse = 0;                  // rounds 2 to 8 in which the best of four was visibly farther than the round before
    int compared = 0;
};

// The visitor's number decides wish, eye and chance: whoever plays the others, in whatever order. Even-numbered
// archetypes are known to breeders; wishes come from all.
SimulatedVisitor visitor_of(const Tournament& tournament, int number);
Played play(const Tournament& tournament, const SimulatedVisitor& visitor, int number, Method method);

// All who are one number's party, in the order in which they press, a round each and then again from the first.
using Guests = std::vector<SimulatedVisitor>;
Guests guests_of(const Tournament& tournament, int number);
// Closeness is that to the wish of the round; a group's, the mean of its members'. Ways that need no picks
// (Method::BestArchetype, Projection) know the first guest's wish alone.
Played play(const Tournament& tournament, const Guests& guests, int number, Method method);

// The word map that breeders have in a simulated world: every second named scene is known, every word's ends are; what
// a site would have that had made half of them itself.
const WordMap& known_half();

struct Standing {
    Method method = Method::NoPick;
    std::vector<double> closeness;       // the mean, after each round
    std::vector<double> standard_error;  // of it
    double worse_share = 0;
    double worse_error = 0;
};
Standing standing_of(Method method, const std::vector<Played>& played);

// How the belief breeder stands among the others. Rounds beyond those played count as the last one.
struct Figures {
    Estimate after_5;            // closeness
    Estimate of_projection;      // of what words said by one who knows the wish would reach; after 5 rounds
    Estimate times_pbil;         // after 5 rounds
    int rounds_to_pbil_15 = 0;   // until it is as close as PBIL after 15; 0: never
    Estimate worse;              // share of rounds in which the best of the four got visibly worse
    Estimate ahead_of_novice_5;  // of a novice who moves as many sliders as a round has answers; after 5 rounds
    Estimate ahead_of_novice_8;
};
Figures figures_of(const std::vector<Standing>& standings);  // of all methods
std::string text_of(const Figures& figures);                 // for people, a line each

// A table for people, and closeness against rounds as a drawing (SVG).
std::string table_of(const Tournament& tournament, const std::vector<Standing>& standings);
std::string plot_of(const Tournament& tournament, const std::vector<Standing>& standings);

}  // namespace quadrat::breeding
