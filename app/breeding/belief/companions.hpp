// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "genome/offer.hpp"

namespace quadrat::breeding {

// How well the trees, the land and the sky of a description go together: palms with what is warm, full crowns with
// green ground, warm light with warm ground, clear and coloured skies with land that has little colour of its own.
// Higher is better; about 0 for those put together by chance.
double accord(const genome::Description& words);

// Puts lands and skies that are offered to other trees than before, so that the sum of the four accords is the
// greatest; what is offered of each aspect stays the same. Nothing happens to an offer without words.
void put_together(genome::Offer& offer);

// Exchanges one candidate's trees, land or sky with another's: values, words and seed.
void exchange(genome::Offer& offer, genome::Aspect aspect, std::size_t one, std::size_t other);

}  // namespace quadrat::breeding
