// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "genome/words.hpp"

namespace quadrat::genome {

std::string words_json(const Description& words);  // {"tropical":0.5,…}, every word; exact

// Any of the words. Throws InputError naming source, place, what is wrong and what would be right: an unknown word, a
// value that is not a number from -1 to 1.
PartialDescription partial_words_from(const nlohmann::json& value, std::string_view source, std::string_view place);

// Every word. Throws InputError as above, and for one that is left out.
Description words_from(const nlohmann::json& value, std::string_view source, std::string_view place);

}  // namespace quadrat::genome
