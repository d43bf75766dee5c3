// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <vector>

#include "breeding/simulation/player.hpp"

namespace quadrat::breeding {

inline constexpr std::array kRoundsReported{3, 5, 8, 15};

struct Tournament {
    genome::Genome genome = genome::Genome::Classic;
    World world = World::NearArchetypes;
    Noise noise = Noise::Mild;
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
Played play(const Tournament& tournament, int visitor, Method method);

struct Standing {
    Method method = Method::NoPick;
    std::vector<double> closeness;       // the mean, after each round
    std::vector<double> standard_error;  // of it
    double worse_share = 0;
};
Standing standing_of(Method method, const std::vector<Played>& played);

// A table for people, and closeness against rounds as a drawing (SVG).
std::string table_of(const Tournament& tournament, const std::vector<Standing>& standings);
std::string plot_of(const Tournament& tournament, const std::vector<Standing>& standings);

}  // namespace quadrat::breeding
