// SPDX-License-Identifier: Apache-2.0
#include "genome/words.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrat::genome {
namespace {

constexpr std::array<Word, kWordCount> kVocabulary{{
#define WORD(id, aspect, low, high, meaning) {WordId::id, #id, Aspect::aspect, low, high, meaning},
#include "genome/words.inc"
#undef WORD
}};

constexpr bool words_stand_by_aspect() {
    for (std::size_t i = 0; i < kVocabulary.size(); ++i) {
        if (kVocabulary[i].id != static_cast<WordId>(i)) return false;
        if (i > 0 && kVocabulary[i].aspect < kVocabulary[i - 1].aspect) return false;
    }
    return true;
}
static_assert(words_stand_by_aspect());

}  // namespace

std::span<const Word> vocabulary() { return kVocabulary; }

std::span<const Word> vocabulary(Aspect aspect) {
    const auto first = std::ranges::find(kVocabulary, aspect, &Word::aspect);
    const auto count = std::ranges::count(kVocabulary, aspect, &Word::aspect);
    return {first, static_cast<std::size_t>(count)};
}

const Word& word(WordId id) {
    assert(id < WordId::count);
    return kVocabulary[static_cast<std::size_t>(id)];
}

std::optional<WordId> word_named(std::string_view name) {
    const auto found = std::ranges::find(kVocabulary, name, &Word::name);
    if (found == kVocabulary.end()) return std::nullopt;
    return found->id;
}

void Description::set(WordId id, float value) {
    values_[static_cast<std::size_t>(id)] = std::isnan(value) ? 0.0F : std::clamp(value, -1.0F, 1.0F);
}

}  // namespace quadrat::genome
