// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "breeding/belief/belief_breeder.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// The rival that won in 2003 ("Genetic selection of parametric scenes", section 5): one slider at a time is chosen and
// turned. In the whole table sliders are words, and any parameter may be fixed by hand; in the classic genome they are
// the 21 parameters. Nothing is believed, nothing is left to chance.
struct SliderState {
    genome::Genome genome = genome::Genome::Classic;
    WordMap map;
    WordRanges ranges{};
    genome::PerAspect<Place> places;                 // as axis_of tells, from 0 to 1
    genome::PerAspect<std::size_t> chosen{};         // the slider of each aspect that the next pick turns
    std::map<genome::ParameterId, float> by_hand{};  // what no word moves any more
    genome::PerAspect<bool> locked{};
    int round = 1;
    friend bool operator==(const SliderState&, const SliderState&) = default;
};

SliderState initial_sliders(genome::Genome genome, const WordMap& map, const WordRanges& ranges);  // all in the middle

// The landscape as the sliders stand, with the chosen slider of each aspect at four positions from end to end.
genome::Offer propose(const SliderState& state, base::Seed seed);

// The chosen sliders of the judged aspects are turned to what was named; the next of each is then chosen.
SliderState learn(const SliderState& state, const genome::Offer& offer, const genome::Pick& pick);

// The landscape as the sliders stand, grown by the chance of `otherwise`.
genome::Candidate wished(const SliderState& state, const genome::Candidate& otherwise);

// A slider, or by name any parameter, to a value in its own unit; nothing: a parameter follows the words again. Throws
// InputError "SOURCE: …": an unknown name, a value outside its range, an aspect that is locked.
SliderState turned(const SliderState& state, std::string_view name, std::optional<double> value,
                   std::string_view source);

// The slider that the next pick of its aspect turns. Throws InputError.
SliderState chosen(const SliderState& state, std::string_view name, std::string_view source);

// All sliders in the order trees, land, sky, for people who choose by going from one to the next.
std::size_t slider_count(genome::Genome genome);
struct SliderPosition {
    genome::Aspect aspect = genome::Aspect::Trees;
    std::string_view name;
    std::optional<genome::WordId> word;  // where it is one
    double share = 0.5;                  // of the way from its low end to its high end
};
SliderPosition slider(const SliderState& state, std::size_t number);

// A step up (+1) or down (-1): a quarter of the way. At an end, or in an aspect that is locked, nothing moves; the
// round counts all the same.
SliderState slid(const SliderState& state, std::size_t number, int direction);

}  // namespace quadrat::breeding
