// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "breeding/words/word_map.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// What a curator allows of a word; low == high locks it there.
struct WordRange {
    float low = -1;
    float high = 1;
    friend bool operator==(const WordRange&, const WordRange&) = default;
};
using WordRanges = std::array<WordRange, genome::kWordCount>;

// What the visitors of a site end up with: how many visits ended nearest to each named scene, an aspect. What breeders
// believe before a pick moves toward it, slowly and so far only.
struct Taste {
    genome::PerAspect<std::map<std::string, int>> chosen;
    std::int64_t since = 0;  // visits up to this one are counted, or forgotten
    friend bool operator==(const Taste&, const Taste&) = default;
};

// Each judged aspect of what a visitor bred counts for the named scene that it is nearest to.
void add(Taste& taste, const WordMap& map, const genome::Candidate& bred, const genome::PerAspect<bool>& judged);

// How much likelier than before a named scene is held: from ½ to 2, and 1 where nobody came. Sixty visits that all end
// with one of sixteen scenes double it; none is ever given up.
double weight_of(const Taste& taste, genome::Aspect aspect, std::string_view name, std::size_t named);

// Log weight of each blend of an atlas, the largest 0. What a curator's ranges do not allow is never made likelier.
std::vector<double> blend_weights(const WordMap& map, genome::Aspect aspect, const Taste& taste,
                                  const WordRanges& ranges);

// {"quadrat":"taste","version":1,"since":1203,"trees":{"old oaks":12,…},"land":{…},"sky":{…}}, exact. Throws
// InputError.
std::string to_json(const Taste& taste);
Taste taste_from(std::string_view json, std::string_view source);

}  // namespace quadrat::breeding
