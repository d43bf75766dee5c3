// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <vector>

#include "breeding/breeder.hpp"
#include "breeding/simulation/tournament.hpp"

namespace quadrat::breeding {

// What a visitor was shown in one round, and what they picked.
struct PastRound {
    genome::Offer offer;
    genome::Pick pick;
};
using PastVisit = std::vector<PastRound>;

// How well a breeder foretells what is picked next, when it learns from what visitors were shown, whoever bred that. A
// pick is foretold by the distances of the four from what the breeder believes is wished for (root mean square over the
// aspect's parameters): with a share m of picks that mean nothing, P = m/4 + (1-m) exp(-d/τ) / Σ exp(-d/τ) (Luce 1959).
// τ and m are those of greatest likelihood, so a little too good where there are few picks.
struct Foretelling {
    BreederKind kind = BreederKind::Belief;
    int picks = 0;            // of second rounds and later; before, nothing is believed
    Estimate bits;            // a pick, beyond chance: 0 knows nothing, 2 knows all; deviation over visits
    double indifference = 0;  // τ
    double meaningless = 0;   // m
};
Foretelling foretelling(BreederKind kind, genome::Genome genome, const WordMap& map, std::span<const PastVisit> visits);

// For people: a line a breeder. `Random` learns nothing: what was named last is what is wished for.
std::string table_of(std::span<const Foretelling> foretellings);

}  // namespace quadrat::breeding
