// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "genome/aspect.hpp"

namespace quadrat::genome {

// Words are the axes a visitor's wish is held in ("Affective scene generation", Hultquist, Gain & Cairns 2006): each a
// value in [-1, 1] from one end to the other. In table order: trees, land, sky.
enum class WordId : std::size_t {
#define WORD(id, ...) id,
#include "genome/words.inc"
#undef WORD
    count
};
inline constexpr std::size_t kWordCount = static_cast<std::size_t>(WordId::count);

struct Word {
    WordId id;
    std::string_view name;  // "wet"; the high end, or what it says of the aspect
    Aspect aspect;
    std::string_view low;   // the English of -1: "dry"
    std::string_view high;  // and of +1: "wet"
    std::string_view meaning;
};

std::span<const Word> vocabulary();
std::span<const Word> vocabulary(Aspect aspect);
const Word& word(WordId id);
std::optional<WordId> word_named(std::string_view name);

// A value for every word, each in [-1, 1].
class Description {
  public:
    float operator[](WordId id) const { return values_[static_cast<std::size_t>(id)]; }
    void set(WordId id, float value);  // clamped; NaN gives 0
    friend bool operator==(const Description&, const Description&) = default;

  private:
    std::array<float, kWordCount> values_{};
};

// Words left out are free: whoever asks does not mind.
using PartialDescription = std::array<std::optional<float>, kWordCount>;

}  // namespace quadrat::genome
