// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <vector>

#include "genome/offer.hpp"
#include "switches/switches.hpp"

namespace quadrat::switches {

// A simulated hand, and what it waits for. Times vary around these by a third, by the chance of the seed.
struct Hand {
    std::chrono::milliseconds thinking{2'500};  // about the four, before anything is pressed
    std::chrono::milliseconds reaction{500};    // from a mark that is seen, or a decision, to the press
    std::chrono::milliseconds growing{1'500};   // until the next four are there
};

struct Pace {
    double minutes = 0;          // for all the picks
    double rounds_a_minute = 0;  // 0 where the visit ended before it got to the last
    double presses_a_round = 0;
    int missed = 0;  // the mark had gone on, and had to come round again
};

// How fast somebody names these, three a round, through the visit and the switches as they are.
Pace pace_of(const std::vector<genome::Pick>& rounds, Buttons buttons, const Options& options, const Hand& hand,
             base::Seed seed);

}  // namespace quadrat::switches
