// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "breeding/breeder.hpp"
#include "genome/parameter_table.hpp"

namespace quadrat::breeding {

// How far the picks of visitors can move a parameter: between the least and the most of it that was ever offered.
struct ParameterReach {
    genome::ParameterId id;
    float least = 0;
    float most = 0;
    double share() const;  // of its range, 0 (stands still) to 1
};

// Something that is there or is not: a choice's value, a country, a feature that is above 0.
struct KindReach {
    std::string name;   // "tree.habit 3", "ground.country 4", "road.share on", "tree.type 0, grown" (where habit is 0)
    double offers = 0;  // share of offers in which at least one of the four has it
};

struct Reach {
    std::vector<ParameterReach> parameters;  // in the table's order
    std::vector<KindReach> kinds;            // in the table's order
    double difference = 0;  // of two in a first offer: root mean square over an aspect's parameters, in ranges; mean
    double median_share() const;
    double share_reaching(double share) const;  // of parameters
    std::size_t still() const;                  // parameters that no pick moves
};

// How it is looked for: so many visits, each of so many offers, in each of which any of the four is named best.
struct ReachSearch {
    int visits = 40;
    int offers = 7;
};
Reach reach_of(const BreederOptions& options, const ReachSearch& search = {});

// For people: what falls short, then the sums. A parameter a line where `is_all`.
std::string text_of(const Reach& reach, bool is_all);

}  // namespace quadrat::breeding
