// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "genome/recipe.hpp"
#include "genome/words.hpp"

namespace quadrat::genome {

// From one end of a word to the other in four answers, as many as there are buttons.
inline constexpr std::array kAnswerSteps{-1.0F, -1.0F / 3, 1.0F / 3, 1.0F};

// What somebody said of a scene, one word at a time: all that is kept of them.
struct WordAnswer {
    Recipe scene;
    std::optional<Description> made_of;  // the words the scene was grown from, where it was bred in words
    WordId word{};
    std::size_t step = 0;  // of kAnswerSteps

    float value() const { return kAnswerSteps.at(step); }
    friend bool operator==(const WordAnswer&, const WordAnswer&) = default;
};

}  // namespace quadrat::genome
