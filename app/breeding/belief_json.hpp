// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "breeding/belief/belief_breeder.hpp"
#include "breeding/pbil.hpp"
#include "breeding/pbil_gaussian.hpp"
#include "breeding/random_search.hpp"
#include "breeding/sliders.hpp"

namespace quadrat::breeding {

// A belief as it is kept, exact:
//   PBIL      {"round":3,"locked":["trees"],"probability":{"trees":[0.5,…],"land":[…],"sky":[…]}}
//   Gaussian  {"round":3,"locked":[],"mean":{"trees":[0.5,…],…},"deviation":{"trees":0.2,…}}
//   random    {"round":3,"locked":[]}
//   belief    {"round":3,"locked":[],"aspects":{"trees":{"blends":[…],"near":{…},"anywhere":{…},"winner":2,
//             "shown":[…],"inherited":"0123456789abcdef"},…}}, of the classic genome "isotropic":{"mean":[…],
//             "covariance":[…],"evidence":-2.1},"archetypes":{…} instead of the first three; the last three once
//             something was picked. What was kept in words alone, as the classic one is, is read too.
//   sliders   {"round":3,"locked":[],"places":{"trees":[0.5,…],…},"chosen":{"trees":0,…},"by_hand":{"land.gain":0.5}}
std::string to_json(const PbilState& state);
std::string to_json(const PbilGaussianState& state);
std::string to_json(const RandomState& state);
std::string to_json(const BeliefState& state);
std::string to_json(const SliderState& state);

// Read for the genome, word map and ranges that the state already has. Throw InputError naming source, the key, what is
// wrong and what would be right; the state is then as before.
void read_belief(std::string_view json, std::string_view source, PbilState& state);
void read_belief(std::string_view json, std::string_view source, PbilGaussianState& state);
void read_belief(std::string_view json, std::string_view source, RandomState& state);
void read_belief(std::string_view json, std::string_view source, BeliefState& state);
void read_belief(std::string_view json, std::string_view source, SliderState& state);

// What of a belief people and programs may read, an aspect: the probability of a 1, a bit; the mean, a parameter; for
// the belief breeder mean and standard deviation, a word (from -1 to 1) or a classic parameter (in its unit).
std::string state_json(const PbilState& state);
std::string state_json(const PbilGaussianState& state);
std::string state_json(const RandomState& state);
std::string state_json(const BeliefState& state);
std::string state_json(const SliderState& state);  // where they stand, which are chosen, what is fixed by hand

}  // namespace quadrat::breeding
