// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "exhibit/visit.hpp"
#include "genome/words.hpp"

namespace quadrat::stage {

// A slider as it is shown: the ends it goes between, and where it stands.
struct ShownSlider {
    std::string low;
    std::string high;
    float share = 0.5F;  // 0 at low, 1 at high
};

// What the four buttons mean beside one landscape; "": nothing.
struct Asked {
    std::string prompt;  // a key of genome::kPrompts
    std::array<std::string, 4> labels;
    std::optional<ShownSlider> slider;
    std::array<std::string_view, 4> keys = {};  // of genome::kPrompts, of labels that are prompts
};

class Spoken;

// In Language, Finale where it asks, Family and Describe (which asks for `word`); nothing elsewhere.
std::optional<Asked> asked_of(const exhibit::State& state, const exhibit::Timings& timings, const Spoken& spoken,
                              std::optional<genome::WordId> word);
// In Slide: a slider of that name, or of a word.
Asked asked_to_slide(const Spoken& spoken, std::string_view name, std::optional<genome::WordId> word, double share);

}  // namespace quadrat::stage
