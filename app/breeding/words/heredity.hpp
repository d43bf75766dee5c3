// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "breeding/words/word_map.hpp"
#include "genome/offer.hpp"
#include "genome/speech.hpp"

namespace quadrat::breeding {

// Where answers moved a wish, aspect by aspect: in words, and one detail that no word tells. "" where nothing moved
// that one would notice, and for candidates without words.
std::string heredity(const genome::Language& language, const WordMap& map, const genome::Candidate& before,
                     const genome::Candidate& now, const genome::Pick& answers);

// So many words to ask a visitor for: one of each aspect in turn, by this chance; none twice. At most as many as there
// are in the smallest aspect, three times.
std::vector<genome::WordId> words_to_ask(base::Seed seed, std::size_t count);

}  // namespace quadrat::breeding
