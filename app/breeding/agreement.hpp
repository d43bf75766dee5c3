// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "breeding/breeder.hpp"

namespace quadrat::breeding {

// How unsure the belief breeder still is of a wish, as a share of what it was unsure of before any pick: the root mean
// square of the words' standard deviations, an aspect, and the mean of those of the aspects that are not locked. 1: as
// before. Picks that agree make it smaller round by round, picks by chance do not. Nothing for breeders that have no
// such belief, and where all is locked.
std::optional<double> doubt_left(const Breeder& breeder);

// Of simulated visitors who see well, four in five come below it within six rounds; of those who press by chance, one
// in fifty.
inline constexpr double kNarrowDoubt = 0.85;

struct Agreement {
    bool is_narrow = false;    // little would come of more rounds
    bool is_changing = false;  // the last picks contradict those before them: doubt has grown
};
// From one round to the next.
Agreement agreement(const Breeder& before, const Breeder& now);

}  // namespace quadrat::breeding
