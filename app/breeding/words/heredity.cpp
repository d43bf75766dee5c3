// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/heredity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "breeding/belief/belief_breeder.hpp"

namespace quadrat::breeding {

std::string heredity(const genome::Language& language, const WordMap& map, const genome::Candidate& before,
                     const genome::Candidate& now, const genome::Pick& answers) {
    if (!before.words || !now.words) return "";
    const auto moved = moved_beside_words(map, before, now);
    std::string text;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!answers[aspect]) continue;
        const std::string in_words = language.heredity(*before.words, *now.words, aspect);
        const std::string detail = language.detail(moved, aspect);
        const char* between = in_words.empty() || detail.empty() ? "" : ", ";
        const std::string both = fmt::format("{}{}{}", in_words, between, detail);
        if (!both.empty()) text.append(text.empty() ? "→ " : " · ").append(both);
    }
    return text;
}

std::vector<genome::WordId> words_to_ask(base::Seed seed, std::size_t count) {
    base::RandomStream chance(seed);
    const std::uint32_t first = chance.below(static_cast<std::uint32_t>(genome::kAspects.size()));
    std::vector<genome::WordId> asked;
    while (asked.size() < count) {
        const auto words = genome::vocabulary(genome::kAspects[(first + asked.size()) % genome::kAspects.size()]);
        const genome::WordId id = words[chance.below(static_cast<std::uint32_t>(words.size()))].id;
        if (std::ranges::find(asked, id) == asked.end()) asked.push_back(id);
    }
    return asked;
}

}  // namespace quadrat::breeding
