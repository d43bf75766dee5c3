// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "genome/offer.hpp"

namespace quadrat::genome {

std::string bits_json(const BitGenome& bits);  // {"trees":"0101…",…}

// {"trees":2,"sky":0}. Throws InputError: "SOURCE: PLACE.trees is 7; a candidate is 0, 1, 2 or 3".
Pick pick_from(const nlohmann::json& value, std::string_view source, std::string_view place);

}  // namespace quadrat::genome
