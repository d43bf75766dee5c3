// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "site/configuration.hpp"
#include "site/configuration_reader.hpp"

namespace quadrat::site {

// The limits of words, [words].
void read_words(ConfigurationReader& reader, std::map<std::string, std::array<double, 2>>& words);

// [themes], and which of them is chosen: visit.theme. No day is of two themes.
void read_themes(ConfigurationReader& reader, Configuration& configuration, const LettersWithoutFont& without_font);

}  // namespace quadrat::site
