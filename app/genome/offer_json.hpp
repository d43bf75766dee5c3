// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "genome/offer.hpp"

namespace quadrat::genome {

// Offers and picks as they are kept on disk, exact: offer_from_json(to_json(o)) == o.
//   {"round":3,"candidates":[{"bits":{"trees":"0101…",…},"seeds":{…},"parameters":{…}}, … four]}
// with "words":{…} beside the parameters where candidates are described in words.
//   {"trees":2,"sky":0}       an aspect left out was not judged
std::string to_json(const Offer& offer);
std::string to_json(const Pick& pick);

// Throw InputError naming source, the key, what is wrong and what would be right.
Offer offer_from_json(std::string_view json, std::string_view source);
Pick pick_from_json(std::string_view json, std::string_view source);

}  // namespace quadrat::genome
